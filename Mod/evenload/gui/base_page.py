"""FreeCAD's page for base geometry, as our panels have it."""

import FreeCAD
from PySide import QtGui

from evenload import host
from evenload.gui.selection import is_outline

_gui = host.gui()

_translate = FreeCAD.Qt.translate


class BaseGeometryPage(_gui.op.TaskPanelBaseGeometryPage):
    """FreeCAD's page for faces and edges, with whole sketches."""

    wanted = "Select level faces, closed edges or sketches."

    def setFields(self, obj):
        self.form.baseList.blockSignals(True)
        self.form.baseList.clear()
        for owner, names in obj.Base:
            for name in names or ("",):
                text = "%s.%s" % (owner.Label, name) if name else owner.Label
                item = QtGui.QListWidgetItem(text)
                item.setData(self.DataObject, owner)
                item.setData(self.DataObjectSub, name)
                self.form.baseList.addItem(item)
        self.form.baseList.blockSignals(False)
        self.resizeBaseList()

    def selectionSupportedAsBaseGeometry(self, selection, ignoreErrors):
        found = any(self._names(item) for item in selection)
        if not found and not ignoreErrors:
            FreeCAD.Console.PrintWarning(_translate("EvenLoad", self.wanted) + "\n")
        return found

    def addBaseGeometry(self, selection):
        for item in selection:
            for name in self._names(item):
                self.obj.Proxy.addBase(self.obj, item.Object, name)
        return bool(selection)

    def updateBase(self):
        items = [self.form.baseList.item(i) for i in range(self.form.baseList.count())]
        self.obj.Base = [
            (item.data(self.DataObject), str(item.data(self.DataObjectSub) or "")) for item in items
        ]

    def _names(self, item):
        if is_outline(item.Object):
            return [""]
        return [name for name in item.SubElementNames if name.startswith(("Face", "Edge"))]


class SurfaceGeometryPage(BaseGeometryPage):
    """The same for faces of any slope, with edges and sketches as guides."""

    wanted = "Select faces that do not stand upright; edges or sketches as guides."
