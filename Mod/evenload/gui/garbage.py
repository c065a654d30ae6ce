"""In which thread Python's garbage is collected.

Python collects in the thread that makes its count full. Among the garbage are panels that FreeCAD
and others have closed, and Qt's widgets may only end in the window's thread: FreeCAD crashes where
another one ends them. So while threads work the window's thread alone collects.
"""

import gc

from PySide import QtCore

LOOK = 100  # ms between looks at the counts, and at whether threads work still

_working = []
_timer = None


def stays_here(thread):
    """While the thread works, garbage is collected only in the window's thread, which calls this
    before the thread starts.
    """
    global _timer
    _working.append(thread)
    if not gc.isenabled():
        return  # by this already, or by somebody who wants none collected at all
    gc.disable()
    if _timer is None:
        _timer = QtCore.QTimer(QtCore.QCoreApplication.instance())  # which ends it, not Python
        _timer.setInterval(LOOK)
        _timer.timeout.connect(_look)
    _timer.start()


def _look():
    _working[:] = [thread for thread in _working if thread.is_alive()]
    if _working:
        _collect_what_is_due()
        return
    _timer.stop()
    gc.enable()


def _collect_what_is_due():
    """What Python would collect now."""
    due = [
        generation
        for generation, (count, most) in enumerate(zip(gc.get_count(), gc.get_threshold()))
        if 0 < most < count
    ]
    if due:
        gc.collect(due[-1])
