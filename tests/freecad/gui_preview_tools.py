"""What gui_preview_session.py sees and does: the preview's state and nodes, gaps of the window,
what a document saves.
"""

import os
import re
import time
import zipfile

import FreeCAD
import FreeCADGui
from gui_tools import OUT, later, press
from PySide import QtCore, QtGui

CANCEL = QtGui.QDialogButtonBox.Cancel
TICK = 20  # ms
# What FreeCAD writes whenever it saves: the document's name and the time, the state of flags that
# tell what was touched.
SAVED = (
    r"""<String value="(before|after)"/>|<String value="\d{4}-\d\d-\d\dT[^"]*"/>| status="\d+\""""
)


class Ticks:
    """A timer that sees for how long, in s, the window does nothing."""

    def __init__(self):
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self._tick)
        self.reset()
        self.timer.start(TICK)

    def reset(self):
        self.last, self.longest = time.monotonic(), 0.0

    def _tick(self):
        now = time.monotonic()
        self.longest, self.last = max(self.longest, now - self.last), now

    def taken(self):
        """The longest gap since the last call."""
        self._tick()
        longest = self.longest
        self.reset()
        return round(longest, 3)


def opened(op):
    """The page of an operation's panel, which opens."""
    later(50)  # the panel before goes first
    op.ViewObject.Document.setEdit(op.ViewObject, 0)
    later(50)
    return page_of(op)


def page_of(op):
    return op.ViewObject.Proxy.panel.featurePages[-1]


def state(op):
    return page_of(op).preview.state


def shown(op):
    """Whether the preview of what is set now is there."""
    return state(op) == "shown"


def turn(op, angle):
    """Sets the engagement angle as one does who types it and leaves the field."""
    box = page_of(op).widgets["EngagementAngle"]
    box.setProperty("rawValue", float(angle))
    box.editingFinished.emit()


def nodes(op):
    """[(the class of each node in it), ...] of the preview's nodes in an operation's scene."""
    root = op.ViewObject.RootNode
    children = [root.getChild(i) for i in range(root.getNumChildren())]
    return [
        [str(n.getChild(i).getTypeId().getName()) for i in range(n.getNumChildren())]
        for n in children
        if str(n.getName()) == "EvenLoadPreview"
    ]


def colours(page):
    """The colours of the preview's line."""
    line = page.preview._node.line
    return set(tuple(c.getValue()) for c in line.colours.rgb.getValues())


def picture(name):
    later(100)
    FreeCADGui.getMainWindow().grab().save(os.path.join(OUT, name + ".png"))
    view = FreeCADGui.activeDocument().activeView()
    view.saveImage(os.path.join(OUT, name + "_view.png"), 900, 700, "Current")


def content(doc, name):
    """Document.xml of a document as it would be saved now, without what changes in any case."""
    file = os.path.join(OUT, name + ".FCStd")
    doc.saveCopy(file)
    with zipfile.ZipFile(file) as saved:
        paths = [saved.read(n) for n in sorted(saved.namelist()) if n.endswith(".nc")]
        return re.sub(SAVED, "", saved.read("Document.xml").decode()), paths


def job_with(name, size, tool=6.0):
    """A document with a job on a block with a square pocket, and its operation."""
    from evenload import host
    from evenload.operations import adaptive
    from models import block_with, face_of, floors_of, rectangle

    doc = FreeCAD.newDocument(name)
    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(face_of(rectangle(0, 0, size, size)))
    doc.recompute()
    job, controller = host.create_job(doc, [part], tool, 255, 6366, 1)
    # The panel of FreeCAD 1.1 rounds a controller's feeds to hundredths of mm/s as it is applied.
    host.set_rapid_feed(controller, 4800.0)
    model = job.Model.Group[0]
    model.ViewObject.Visibility = False
    op = adaptive.Create("Pocket", parentJob=job, toolController=controller)
    op.Base = [(model, tuple(floors_of(model.Shape)))]
    doc.recompute()
    FreeCADGui.activeDocument().activeView().viewTop()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return doc, job, op


def memory():
    """MB of this process."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def gone_widgets(page):
    """Names of the page's widgets that Qt has deleted."""
    parts = {**page.widgets, "form": page.form, "live": page.live, "top": page.status.top}
    found = []
    for name, widget in parts.items():
        try:
            widget.objectName()
        except RuntimeError:
            found.append(name)
    return found


def cancelled():
    """The s until Cancel is done."""
    begin = time.monotonic()
    press(CANCEL)
    return round(time.monotonic() - begin, 3)
