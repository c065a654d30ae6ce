"""What the window Simulation computes: operations read in FreeCAD's own thread, simulated in
another one.
"""

from evenload import host, waiting
from evenload.gui import preferences
from evenload.pictures.load_rows import Run
from evenload.settings.properties import is_ours
from evenload.simulation import job, walls

MOST_SAMPLES = 100_000  # along the path's length; longer paths are looked at more coarsely
FINEST = 0.1  # mm between samples


def step_of(operation):
    """mm between the samples along an operation's path."""
    return max(FINEST, operation.Path.Length / MOST_SAMPLES)


def material_of(operation):
    """The material whose force is shown: that of ours, the one that is preferred for others; None
    without a spindle speed.
    """
    controller = host.controller_of(operation)
    if controller is None or not controller.SpindleSpeed > 0:
        return None
    inner = host.operation_under(operation)
    return inner.Material if is_ours(inner) else preferences.material()


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
        walls.along_walls(found)
        yield Run(name, found)


def loads(setup, options, told):
    """The task that generates the Simulation of one setup, which knows its walls. Arguments as for
    simulated().
    """

    def going(share):
        told(share)
        return goes_on(share)

    found = setup.simulate(progress=going, **options)
    if found.cancelled:
        raise waiting.Stopped()
    walls.along_walls(found)
    yield found


def goes_on(share):
    """Whether the task of this thread shall go on."""
    try:
        waiting.go_on(share)
    except waiting.Stopped:
        return False
    return True
