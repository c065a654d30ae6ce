"""Arrows, keys and the wheel of spin boxes, of which Qt tells by no signal of its own."""

from PySide import QtCore

from evenload.gui import fields
from evenload.gui.slots import slot


class Stepping:
    """Has take() called after a spin box was changed by its arrows, by keys or by the wheel: when
    it has another value, and nobody has typed that. What is typed is done with editingFinished.

    take: a bound method, whose object is not kept alive, and its arguments. It is called, too, when
    a program has changed the value, and has to tell whether the box still holds another one.
    """

    def __init__(self, box, take, *arguments):
        self._edit, self._is_ended = fields.edit_of(box), False
        self._take = slot(take, *arguments)
        self._timer = QtCore.QTimer(box)  # the box has its new value by then
        self._timer.setSingleShot(True)
        self._timer.setInterval(0)
        self._timer.timeout.connect(slot(self._tell))
        # Of FreeCAD's boxes Python sees no signal of the value, of Qt's none of the text.
        changed = box.valueChanged if hasattr(box, "valueChanged") else self._edit.textChanged
        changed.connect(slot(self._changed))

    def end(self):
        """From now on nothing is called any more, whatever Cancel shows in the box at last."""
        self._is_ended = True
        self._timer.stop()

    def _changed(self):
        if not self._is_ended and not self._edit.isModified():
            self._timer.start()

    def _tell(self):
        if not self._edit.isModified():  # nobody has begun to type meanwhile
            self._take()
