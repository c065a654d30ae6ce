"""In which thread Python's garbage is collected.

Python collects in the thread that makes its count full. Among the garbage are panels that FreeCAD
and others have closed, and Qt's widgets may only end in the window's thread: FreeCAD crashes where
another one ends them. So while the threads of a Worker work the window's thread alone collects.
"""

import gc

from PySide import QtCore

LOOK = 100  # ms between looks at the counts, and at whether threads work still

_working = []
_timer = None
_is_off_by_this = False


def stays_here(thread):
    """While the thread works, garbage is collected only in the window's thread, which calls this
    before the thread starts.
    """
    global _timer
    _working.append(thread)
    _switch_off()
    if _timer is None:
        _timer = QtCore.QTimer(QtCore.QCoreApplication.instance())  # which ends it, not Python
        _timer.setInterval(LOOK)
        _timer.timeout.connect(_look)
    _timer.start()


def _switch_off():
    """Somebody else may have switched it off before, and on again meanwhile."""
    global _is_off_by_this
    if gc.isenabled():
        gc.disable()
        _is_off_by_this = True


def _look():
    global _is_off_by_this
    _working[:] = [thread for thread in _working if thread.is_alive()]
    if _working:
        _switch_off()
        if _is_off_by_this:
            _collect_young()
        return
    _timer.stop()
    if _is_off_by_this:
        gc.enable()
        _is_off_by_this = False


def _collect_young():
    """What Python would collect now of young objects; it goes through the old ones by itself, once
    it is switched on again, for that takes a user's time.
    """
    if gc.get_count()[0] > gc.get_threshold()[0]:
        gc.collect(1)
