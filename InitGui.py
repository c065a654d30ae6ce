"""FreeCAD runs this at the start of its GUI: our commands join the Path / CAM workbench's menu and
toolbar.
"""


def _start():
    import evenload.gui

    evenload.gui.start()


_start()
del _start
