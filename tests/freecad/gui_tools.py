"""What the scripts share that tests run in FreeCAD's GUI (`in_gui` of conftest.py): clicks, keys,
pictures, and what was seen as JSON in $EVENLOAD_GUI_OUT/result.json.
"""

import contextlib
import faulthandler
import gc
import json
import os
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

OUT = os.environ["EVENLOAD_GUI_OUT"]
MOST = 120  # s that anything is waited for, on a machine that others use
METRIC, INCHES = 6, 3  # FreeCAD's unit schemas: mm and mm/min, decimal inches
LAST_ERROR = "The session ends."  # stands in the report view, or its errors were not seen
result = {}
# Sentences that the script provokes: the only errors that the report view may hold at the end.
result["provoked"] = []
_last_words = open(os.path.join(OUT, "hang.txt"), "w")  # of a FreeCAD that hangs or crashes
faulthandler.enable(_last_words)
faulthandler.dump_traceback_later(480, file=_last_words, exit=True)


@contextlib.contextmanager
def panel_of_another():
    """While this lasts, a panel is open that is no operation's of ours."""
    FreeCADGui.Control.showDialog(_Panel())
    later(50)
    try:
        yield
    finally:
        FreeCADGui.Control.closeDialog()
        later(50)


class _Panel:
    def __init__(self):
        self.form = QtGui.QWidget()


def wait(milliseconds):
    """Lets the GUI go on for a while."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def until(is_so, most=MOST):
    """Lets the GUI go on until something is so, for `most` s at the longest; the s that it took."""
    begin = time.monotonic()
    while not is_so():
        assert time.monotonic() - begin < most, "it never came"
        wait(5)
    return round(time.monotonic() - begin, 3)


def later(milliseconds=300):
    """Lets the GUI go on for a while. What FreeCAD's panels leave goes at once: where Qt makes a
    widget in the place of one that is gone, Python may else take it for that one. What is left in
    cycles takes as long as many a wait, so `wait` and `until` leave it.
    """
    from evenload.gui.wrappers import forget_the_dead

    wait(milliseconds)
    # What is to be deleted once the script is done: FreeCAD lets go of its widgets' wrappers so.
    QtCore.QCoreApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)
    gc.collect()
    forget_the_dead()


def keep_modules():
    """What is there now are modules and FreeCAD's main window: what goes through Python's objects
    after each step, for those that are dead, leaves them out from now on.
    """
    gc.collect()
    gc.freeze()


def widgets(kind):
    """All widgets of a class. Not by the main window's findChildren: its wrapper would keep those
    of the children, and these are taken for other widgets when they are gone.
    """
    return [each for each in QtGui.QApplication.allWidgets() if isinstance(each, kind)]


def picture(name):
    window = FreeCADGui.getMainWindow()
    docks = [d for d in widgets(QtGui.QDockWidget) if d.isVisible()]
    left = [d for d in docks if window.dockWidgetArea(d) == QtCore.Qt.LeftDockWidgetArea]
    window.resizeDocks(left, [420] * len(left), QtCore.Qt.Horizontal)
    later()
    window.grab().save(os.path.join(OUT, name + ".png"))


def on_screen(widget):
    """What the screen shows of a widget: the 3D view, too, and what FreeCAD 1.1 lays over that."""
    corner = widget.mapToGlobal(QtCore.QPoint(0, 0))
    rect = corner.x(), corner.y(), widget.width(), widget.height()
    return QtGui.QGuiApplication.primaryScreen().grabWindow(0, *rect)


def panel_buttons():
    """The buttons of the panel, as soon as it is open."""
    from evenload.gui.wrappers import forget_the_dead

    forget_the_dead()  # also what FreeCAD's own panels left
    until(_panels_buttons)
    return _panels_buttons()[0]


def _panels_buttons():
    boxes = widgets(QtGui.QDialogButtonBox)
    return [b for b in boxes if b.isVisible() and b.button(QtGui.QDialogButtonBox.Ok)]


def press(kind):
    """Clicks a button of the panel. By Qt's own name of the slot: where a widget was made in the
    place of one that is gone, Python may still take it for that one, which has no such method; or
    for one that is no more, and then what the button would tell is told by its box.
    """
    box = panel_buttons()
    try:
        button = box.button(kind)
        assert QtCore.QMetaObject.invokeMethod(button, "click", QtCore.Qt.DirectConnection)
    except RuntimeError:
        told = {QtGui.QDialogButtonBox.Ok: "accepted", QtGui.QDialogButtonBox.Cancel: "rejected"}
        getattr(box, told[kind]).emit()


def click(widget, at=None):
    """A click with the left button, at a point of the widget or in its middle."""
    at = QtCore.QPointF(at if at is not None else widget.rect().center())
    everywhere = QtCore.QPointF(widget.mapToGlobal(at.toPoint()))
    left, none = QtCore.Qt.LeftButton, QtCore.Qt.NoButton
    for kind, button, held in (
        (QtCore.QEvent.MouseMove, none, none),  # FreeCAD looks for what is under the mouse first
        (QtCore.QEvent.MouseButtonPress, left, left),
        (QtCore.QEvent.MouseButtonRelease, left, none),
    ):
        event = QtGui.QMouseEvent(kind, at, everywhere, button, held, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(widget, event)


def leave(widget):
    """Takes the focus from a widget, as a click elsewhere does."""
    widget.clearFocus()
    event = QtGui.QFocusEvent(QtCore.QEvent.FocusOut, QtCore.Qt.MouseFocusReason)
    QtGui.QApplication.sendEvent(widget, event)


@contextlib.contextmanager
def answering(answer):
    """While this lasts, answer(dialog) is called for every modal dialog that shows, until it is
    closed. The list that it gives has the dialogs' titles.
    """
    seen, met = [], []

    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None or not dialog.isVisible():
            return
        if dialog not in met:
            met.append(dialog)
            seen.append(dialog.windowTitle())
        answer(dialog)

    timer = QtCore.QTimer()
    timer.timeout.connect(look)
    timer.start(20)
    try:
        yield seen
    finally:
        timer.stop()


def fold_all():
    """Has the parts of panels that are opened from now on be folded, as with a fresh FreeCAD."""
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/EvenLoad").RemGroup("Panels")


def unfold_all(page):
    """Unfolds all parts of an operation's page."""
    for fold in page.folds.values():
        fold.unfold()
    later(100)


def base_list(op):
    """The lines of the list of bases in an operation's open panel. By the list's model, and nothing
    of it is kept: the list's items are no QObjects, so that PySide would not learn of their end and
    take what is made in the place of one for that item.
    """
    model = op.ViewObject.Proxy.panel.featurePages[0].form.baseList.model()
    return [model.index(row, 0).data() for row in range(model.rowCount())]


def set_up():
    """mm/min, none of the warnings that FreeCAD gives new users in dialogs, and a camera that is at
    once where it shall be.
    """
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    view.SetBool("UseNavigationAnimations", False)  # since 1.0
    for module in ("Path", "CAM"):
        settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/" + module)
        settings.SetBool("WarningSuppressVelocity", True)
        settings.SetBool("WarningSuppressSelectionMode", True)
    FreeCAD.Units.setSchema(METRIC)


def choose_units(schema):
    """Has FreeCAD show values as a user chooses in its preferences."""
    FreeCAD.Units.setSchema(schema)
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", schema)
    later(100)


def with_plain_views():
    """Without a graphics card a background that changes takes most of what drawing takes."""
    view = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    for each in ("Gradient", "RadialGradient", "ShowNaviCube"):
        view.SetBool(each, False)
    view.SetBool("Simple", True)


def workbench(*size):
    """The workbench, set up, in a window of so many pixels or as it is."""
    from evenload import host

    set_up()
    FreeCADGui.activateWorkbench(host.WORKBENCH)
    if size:
        FreeCADGui.getMainWindow().resize(*size)
    later(800)


def begun(width, height):
    """An empty document in the workbench, in a window of so many pixels."""
    workbench(width, height)
    keep_modules()
    return FreeCAD.newDocument("Session")


def freecads_adaptive(job, controller):
    """FreeCAD's own operation, called Theirs. What it says of itself stands in the report view like
    an error.
    """
    from evenload import host

    result["provoked"] += [
        "SetupSheet has no support for Theirs",
        "Adaptive toolpath processing started",
        "Done. Elapsed time",
    ]
    return host.freecads_adaptive("Theirs", job, controller)


def ours_and_theirs(doc, outline):
    """(the job, our Adaptive, FreeCAD's) on the floor of a pocket of a face's shape, computed and
    seen from above.
    """
    from evenload import host
    from evenload.operations import adaptive
    from models import block_with, floors_of

    part = doc.addObject("Part::Feature", "Part")
    part.Shape = block_with(outline)
    doc.recompute()
    job, controller = host.create_job(doc, [part], 6, 255, 6366, 1)
    model = job.Model.Group[0]
    ours = adaptive.Create("Ours", parentJob=job)
    theirs = freecads_adaptive(job, controller)
    ours.Base = theirs.Base = [(model, tuple(floors_of(model.Shape)))]
    doc.recompute()
    model.ViewObject.Visibility = False
    FreeCADGui.activeDocument().activeView().viewTop()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    return job, ours, theirs


def toolbar_texts():
    """The texts of our commands in FreeCAD's toolbars. By the bars' own actions: the main window's
    are many that end, and would be taken for what is made in their places.
    """
    from evenload import host

    bars = [bar for bar in widgets(QtGui.QToolBar) if bar.objectName() == host.TOOLBAR]
    texts = [action.text().replace("&", "") for bar in bars for action in bar.actions()]
    return [text for text in texts if text.startswith("EvenLoad")]


def is_enabled(command):
    """Whether a command is, for what is selected now."""
    FreeCADGui.updateGui()
    return bool(FreeCADGui.Command.get(command).isActive())


def report_view():
    """The lines of the report view."""
    view = next(w for w in widgets(QtGui.QTextEdit) if w.objectName() == "Report view")
    return [line for line in view.toPlainText().splitlines() if line.strip()]


def show_errors_only():
    """From now on the report view shows nothing but errors; gives what stood there before."""
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/OutputWindow")
    for kind in ("checkLogging", "checkMessage", "checkWarning"):
        settings.SetBool(kind, False)
    settings.SetBool("checkError", True)
    FreeCAD.Console.PrintError("\n")  # FreeCAD 1.1 may leave its own last line open
    later(100)
    return report_view()


def run(session, are_views_plain=True):
    """Calls session() as soon as FreeCAD has started, writes what it put into `result` and what
    stands in the report view, and ends FreeCAD.
    """

    def all_of_it():
        if are_views_plain:
            with_plain_views()
        keep_modules()
        started = show_errors_only()
        try:
            session()
        except BaseException:
            result["traceback"] = traceback.format_exc()
        FreeCAD.Console.PrintError(LAST_ERROR + "\n")
        # FreeCAD 1.1 writes into the report view by and by. Who reads it sees whether it came.
        with contextlib.suppress(AssertionError):
            until(lambda: any(LAST_ERROR in line for line in report_view()), 10)
        # What FreeCAD says as it starts is no error unless it looks like one.
        result["report_view"] = [
            (line, number >= len(started)) for number, line in enumerate(report_view())
        ]
        with open(os.path.join(OUT, "result.json"), "w") as file:
            json.dump(result, file, indent=1)
        os._exit(0)

    QtCore.QTimer.singleShot(500, all_of_it)
