"""Operations' panels that scripts open in FreeCAD's GUI, one after the other, in narrow docks."""

import os

import FreeCADGui
from gui_fit import dock_of, resize_dock, too_wide
from gui_tools import OUT, later, press, unfold_all
from PySide import QtGui

WIDTHS = 264, 300  # pixels of FreeCAD's dock: as it is at first, and somewhat wider


def picture(name):
    FreeCADGui.getMainWindow().grab().save(os.path.join(OUT, name + ".png"))


def opened(op):
    """The page of an operation's panel, which opens."""
    later(50)  # the panel before goes first
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later()
    return op.ViewObject.Proxy.panel.featurePages[-1]


def in_panel(op, look):
    """What look(page) tells of an operation's panel, which opens and closes. Nothing else may keep
    a page: with it FreeCAD's panel stays, and the widgets of the next are taken for its own.
    """
    seen = look(opened(op))
    press(QtGui.QDialogButtonBox.Cancel)
    later()
    return seen


def fit_of(page, name):
    """{where: what does not fit} of a panel in a narrow dock, folded or not."""
    seen = {}
    for folding in ("folded", "unfolded"):
        if folding == "unfolded":
            unfold_all(page)
        for width in WIDTHS:
            resize_dock(page, width)
            look = "%s %d %s" % (name, dock_of(page).width(), folding)
            picture(look)
            seen[look] = too_wide(page)
    return seen


def operation_on(doc, job, model, floor, command):
    """The operation that a command makes of a floor, after OK in its panel."""
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(doc.Name, model.Name, floor)
    FreeCADGui.runCommand(command)
    later(600)
    press(QtGui.QDialogButtonBox.Ok)
    later(500)
    return job.Operations.Group[-1]
