"""What the dock Finishing Advisor computes, in a thread."""

from evenload import advisor, waiting
from evenload.gui import preferences
from evenload.gui.observer import Observer, bits_of, own_properties
from evenload.operations.checks import DEPTHS
from evenload.settings.table import FINISHING

# Of models, controllers and the operation: what changes what is compared. Its pattern and angle do
# not, in whose place each strategy has its own.
PROPERTIES = {
    *("Shape", "Placement", "Base", "ToolController", "Tool", "HorizFeed", "VertFeed"),
    *("HorizRapid", "SpindleSpeed", "SpindleDir", *DEPTHS, *(row.name for row in FINISHING)),
} - {"Strategy", "PassAngle"}


def answers(question, told):
    """The task that generates each Advice. told: called with the share that is done, in the thread
    of the task.
    """
    asked = waiting.asked()

    def watch(share):
        told(share)
        return asked(share)

    with waiting.asking(watch):
        yield from advisor.answers(question)


def observer_of(job, operation, changed):
    """The Observer of what is compared of a job, with its tool bits, and of an operation or None.
    changed: called with whether one of these is no longer there.
    """
    controllers = job.Tools.Group
    objects = [job, *job.Model.Group, *controllers, *([operation] if operation else [])]
    bits = bits_of(controllers)
    return Observer(objects, PROPERTIES | own_properties(bits), changed, bits)


def preferred_settings():
    """{name: value} of what the user prefers new finishing operations to begin with."""
    names = {row.name for row in FINISHING}
    kept = {row.name: preferences.default_of(row) for row in preferences.ROWS if row.name in names}
    return {name: value for name, value in kept.items() if value is not None}
