"""Fields of settings that an expression sets: they show its value, and are not edited.

FreeCAD's own fields for quantities see to their property's expression, but know no setting that
follows it.
"""

import FreeCAD

from evenload.operations.following import ANGLE, STEP, bound
from evenload.settings.labels import LABELS

_translate = FreeCAD.Qt.translate


def held(obj, freecads):
    """{setting: the one whose expression sets it} of an operation; what FreeCAD's own fields hold,
    whose names are in `freecads`, is left out.
    """
    names = bound(obj)
    found = {name: name for name in names if name not in freecads}
    for name, leader in ((ANGLE, STEP), (STEP, ANGLE)):
        if leader in names and name not in names:
            found[name] = leader
    return found


def tip_of(setting, held_ones):
    """The tooltip of a setting's field. held_ones: what held() says."""
    tip = _translate("EvenLoad", setting.doc)
    if setting.name not in held_ones:
        return tip
    leader = _translate("EvenLoad", LABELS[held_ones[setting.name]])
    told = _translate("EvenLoad", "Set by the expression of '%s'") % leader
    return "\n".join([tip, told])
