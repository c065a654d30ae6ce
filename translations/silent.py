"""Which texts of the code are told to a user, and which are names that code alone reads.

All that is not named here is to be translated: a new text is collected until somebody says here
that nobody sees it.
"""

import re

# Where sentences are made that are shown in the window. Others are for scripts and job files alone.
TELLING = (
    *("commands.py", "compiled.py", "findings.py", "machines.py", "materials.py", "refusals.py"),
    *("tool.py", "settings/ranges.py", "settings/setting.py"),
    *("geometry/*.py", "operations/*.py", "stability/[!p]*.py"),
    *("simulation/earlier.py", "simulation/job.py", "simulation/part.py", "simulation/proof.py"),
    *("dynamics/frf.py", "dynamics/frf_files.py", "dynamics/modes.py", "dynamics/vibration.py"),
    *("inspection/dmis.py", "inspection/points.py", "inspection/predictions.py"),
    *("inspection/tables.py", "face_inspection/datum.py"),
    *("face_inspection/evaluation.py", "face_inspection/faces.py", "face_inspection/measured.py"),
    *("face_inspection/patterns.py", "host/posts.py", "gui/view3d.py"),
    *(
        "advisor/answering.py",
        "advisor/reading.py",
        "surface_simulation/r*.py",
        "ball_end/places.py",
        "suggestion/*.py",
    ),
)
# What tells of the values in a file; elsewhere only a script can give a value that is none.
OF_FILES = ("machines.py", "vibration.py")
# Of these files, what is no sentence for the window.
NOT_TOLD = {
    "(Cancelled: nothing is cut here)",  # a comment of the G-code
    "EvenLoad results",  # a group of properties
    "Modes of vibration at the tool's tip, for stability charts: JSON, see docs/stability_chart.md",
    "What the tool stands, for suggested feeds and speeds: JSON, see docs/optimisation.md",
    "not planar",
    "speed depth cut_mode removal_rate spectral_radius surface_location_error",
    # Of predict() and read() in a script.
    "%s was fitted to feed directions from 0 to 90 degrees; here it is a guess.",
    "The finishing operation has no '%s': it has %s.",
    # Of roughness() in a script.
    *(
        "No pass cuts the faces at x = %g, y = %g.",
        "The patch is %g mm wide: it must be more than 0.",
    ),
    # Pieces of what stands in joined.py.
    *("arc length", "of the type ", " and its ", ", at a radius of %s.", "%s %s, not %s %s"),
    *("%s of %s", "%.12g mm/min", "turn the spindle at %.0f rev/min"),
    *("%s on %s", "edge on %s", "There is no %s: pick the geometry anew."),
    "%s What is picked makes %d lines.",
}
# In the window's files, the calls whose arguments nobody sees.
SILENT_CALLS = {
    *("getattr", "hasattr", "setattr", "startswith", "endswith", "join", "split", "replace"),
    *("property", "setProperty", "setObjectName", "setStyleSheet", "ParamGet", "createWidget"),
    *("invokeMethod", "getIcon", "QColor", "open", "Signal", "addModule", "doCommand"),
    "import_module",
}
_SILENT = re.compile(
    r"[a-z_.]+|"  # names, and words that SPOKEN does not have
    r"[A-Z][a-z]+(?:[A-Z][a-z]+)+|"  # properties
    r"EvenLoad[A-Z_]\w*|\w+[.]svg|"
    r"/[A-Z]\w+|"  # groups of parameters
    r"[#<\0.*].*|(?:; )?(?:font|color|text|icon)[ :-].*|"  # colours, HTML, style sheets
    r"QPushButton .*|"
    r".*::.*|User parameter:.*|evenload\..*|utf-8|"
    r"[^A-Za-z]*|[\d. ]+(?:mm|mm/min|in|°)|"  # numbers
    r"%#?[\d.*]*[dfg]°?|%\.(?:\*f|4g) ?%s|%s\n|"  # nothing but places
    r"\[%s\]|%s(?:\.|\.%s = | \()%s\)?|%s = %s or %s|"
    r".*%r.*|"  # lines of macros
    r"\(\?.*"  # expressions
)
_WORDS = {
    *("Active", "Angle", "Base", "Edge", "FreeCAD", "Group", "Job", "Label", "Length"),
    *(
        "Operations",
        "Path",
        "Pixmap",
        "Placement",
        "Report",
        "Resources",
        "Shape",
        "Size",
        "Value",
        "Velocity",
    ),
    *(
        "Decimals",
        "Touched",
        "Up-to-date",
        "MenuText",
        "ToolTip",
        "xx",
        "yy",
        "DMIS",
        "Halton-Zaremba",
        "arc length",
    ),
    *("m/N", "mm/N", "um/N", "uin/lbf", "g/N", "(m/s)/N", "(m/s2)/N", "N/µm", "Hz", " Hz", "kN/m"),
    *("mm", "N", "%s, Ø %.5g %s", "%.12g mm/min"),
    *("µin", "m/min", "ft/min", "N m", "N\u00b7s", "W", "Rz", "CX", "CV"),
    *("Arcs", "Check", "Component", "Report view", "Python console"),
    *("JSON (*.json)", "CSV (*.csv)", "HTML (*.html)", "G-code (*.ngc *.nc *.gcode)"),
    *("%.0f %%", "mm²", "in²", "tip share"),
    *("PNG (*.png);;SVG (*.svg)", "CSV (*.csv);;DMIS (%s)"),
}
# Words of the window in small letters, which would else pass for names.
_SPOKEN = {"cut", "entry", "link", "rapid", "none", "force", "torque", "power", "to"}


def is_silent(text):
    """Whether a text of the window's files is no words for a user."""
    return text in _WORDS or (text not in _SPOKEN and _SILENT.fullmatch(text) is not None)
