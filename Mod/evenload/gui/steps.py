"""Steps to undo of docks, which may stand beside an open panel."""

import contextlib

import FreeCAD
import FreeCADGui

from evenload.stability import taking

_translate = FreeCAD.Qt.translate


def page_of(operation):
    """The page of an operation's settings in its panel; None where that is not open."""
    proxy = getattr(getattr(operation, "ViewObject", None), "Proxy", None)
    panel = getattr(proxy, "panel", None)
    return panel.featurePages[-1] if panel is not None else None


def shows_preview(operation):
    """Whether the 3D view shows the preview in an operation's panel in place of its path."""
    preview = getattr(page_of(operation), "preview", None)
    return preview is not None and preview.is_in_view


def refusal(operation):
    """Why nothing can be set now, in a sentence; '' where it can. A panel has a step to undo open,
    which FreeCAD would close for another one: Cancel could not take back what the user edited.
    """
    if FreeCADGui.Control.activeDialog() and page_of(operation) is None:
        return _translate("EvenLoad", "Close the open panel first.")
    return ""


def step(document, operation, name):
    """What is set while this lasts is one step to undo; while the operation's panel is open it is
    a part of the panel's. Only without a refusal. operation: None for one that is not made yet.
    """
    if page_of(operation) is not None:
        return contextlib.nullcontext()
    return taking.undoable(document, name)
