"""What the user sees a setting called, in panels and in messages.

Code and the core name settings as macros and job files do, by their properties; `told` puts the
panel's labels into a sentence on its way to the user.
"""

import re

from evenload.settings.table import ALL

LABELS = {row.name: row.label for row in ALL}
# On FreeCAD's own pages of an operation and of its tool controller.
FREECADS = {
    "StartDepth": "Start Depth",
    "FinalDepth": "Final Depth",
    "StepDown": "Step Down",
    "SafeHeight": "Safe Height",
    "ClearanceHeight": "Clearance Height",
    "HorizFeed": "Horiz. Feed",
    "VertFeed": "Vert. Feed",
    "SpindleDir": "Spindle",
}


def told(text):
    """A text with the labels of the properties that it names. The property's name follows in
    parentheses where the label does not show what it is.
    """
    return _NAMES.sub(lambda found: _IN_TEXT[found.group()], text)


def _in_text(name, label):
    same = re.sub("[^a-z]", "", label.lower()) == name.lower()
    return label if same else "%s (%s)" % (label, name)


# Names that are words of English too are their own labels, and stay.
_IN_TEXT = {
    name: _in_text(name, label)
    for name, label in {**LABELS, **FREECADS}.items()
    if name not in ("Arcs", "Check", label)
}
_NAMES = re.compile(r"\b(?:%s)\b" % "|".join(_IN_TEXT))


def in_text(name):
    """What `told` puts in the place of a property's name; None where the name stays."""
    return _IN_TEXT.get(name)
