"""What the window Simulation computes: operations read in FreeCAD's own thread, simulated in
another one.
"""

from evenload import host, waiting
from evenload.gui.load_view import step_of
from evenload.pictures.load_rows import Run
from evenload.simulation import job


def setups_of(operations, material, machine):
    """[(name, function that simulates it), ...] of operations, each as if the others had not been
    there. material: a name; machine: a name or file, None for the programmed feeds alone. Raises
    ValueError for an operation that cannot be simulated.
    """
    names = [operation.Name for operation in operations]
    found = []
    for operation in operations:
        controller = host.controller_of(operation)
        has_speed = controller is not None and controller.SpindleSpeed > 0
        options = {
            "step": step_of(operation),
            "material": material if has_speed else None,
            "machine": machine,
        }
        found.append((operation.Label, job.read(operation, without=names), options))
    return found


def simulated(setups, told):
    """The task that generates the Runs of setups. told: called with the share that is done, 0 to 1,
    in the thread of the task.
    """
    for number, (name, setup, options) in enumerate(setups):

        def going(share, number=number):
            told((number + share) / len(setups))
            return goes_on(share)

        found = setup.simulate(progress=going, **options)
        if found.cancelled:
            raise waiting.Stopped()
        yield Run(name, found)


def goes_on(share):
    """Whether the task of this thread shall go on."""
    try:
        waiting.go_on(share)
    except waiting.Stopped:
        return False
    return True
