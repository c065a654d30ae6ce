"""The command Optimise: what tool and material suggest beside what is set now."""

from evenload import host
from evenload.gui.optimise_view import OptimiseView

_shown = []  # the OptimiseView that is there


def show(operation):
    """Opens the dock for an operation, or the one that a dressup dresses, in place of one that is
    open.
    """
    close()
    _shown.append(OptimiseView(host.operation_under(operation), close))
    return _shown[-1]


def close():
    """Removes the dock, if there is one."""
    while _shown:
        _shown.pop().remove()
