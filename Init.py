"""FreeCAD runs this at start, with and without a GUI: documents find our operations only when
`evenload` is imported.
"""


def _start():
    # FreeCAD runs this file inside a function, without __file__: the addon is found among the Mod
    # folders.
    import os
    import sys

    import FreeCAD

    for folder in FreeCAD.__ModDirs__:
        if os.path.isfile(os.path.join(folder, "Mod", "evenload", "__init__.py")):
            modules = os.path.join(folder, "Mod")
            if modules not in sys.path:
                sys.path.append(modules)
            break
    import evenload  # noqa: F401


_start()
del _start
