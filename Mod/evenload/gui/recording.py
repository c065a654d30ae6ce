"""What FreeCAD's macro recorder writes down of an operation's panel: lines that make the operation,
or set it as it is, when they are run again, with a window or without.

FreeCAD runs the lines that it records. So each of them changes nothing where the operation is
already as it says.
"""

import FreeCADGui

from evenload import host
from evenload.settings.setting import LINKS, POINT, SPEED

DEPTHS = ("StartDepth", "FinalDepth", "StepDown", "SafeHeight", "ClearanceHeight")
PLAIN = ("CoolantMode", "Active", "Label")  # FreeCAD's own properties that the panel shows
NAME = "evenload_operation"  # of the variable that the lines use


def record(obj):
    """Tells the recorder of an operation as its panel is left by OK."""
    FreeCADGui.addModule("FreeCAD")
    FreeCADGui.addModule(type(obj.Proxy).__module__)
    for line in lines_of(obj):
        FreeCADGui.doCommand(line)


def lines_of(obj):
    """The lines, beside the imports of FreeCAD and of the operation's module."""
    made = "%s.Create(%r, parentJob=%s, toolController=%s)" % (
        type(obj.Proxy).__module__,
        obj.Name,
        _object(host.parent_job(obj)),
        _object(obj.ToolController),
    )
    yield "%s = %s or %s" % (NAME, _object(obj), made)
    yield _set("ToolController", _object(obj.ToolController))
    yield _set("Base", _base(obj.Base))
    bound = dict(obj.ExpressionEngine)
    # What an earlier line has given an expression that is no more.
    yield (
        "[%s.setExpression(path, None) for path, _ in %s.ExpressionEngine if path not in %r]"
        % (NAME, NAME, sorted(bound))
    )
    for row in obj.Proxy.settings:
        if row.name not in bound and not _follows(obj, row):
            yield _set(row.name, _value(obj, row))
        for path in bound:  # of a place each number has one of its own
            if path.lstrip(".").split(".")[0] == row.name:
                yield "%s.setExpression(%r, %r)" % (NAME, path, bound[path])
    for name in DEPTHS:
        if hasattr(obj, name):
            yield "%s.setExpression(%r, %r)" % (NAME, name, bound.get(name))
            if name not in bound:
                yield _set(name, repr(getattr(obj, name).Value))
    for name in PLAIN:
        if hasattr(obj, name):
            yield _set(name, repr(getattr(obj, name)))


def _follows(obj, row):
    """Whether a setting follows the tool, the geometry or another one."""
    is_set = row.name in obj.OwnValues
    return row.name == "SideStep" or (row.name in obj.Proxy.own_names() and not is_set)


def _set(name, value):
    return "%s.%s = %s" % (NAME, name, value)


def _object(obj):
    return "FreeCAD.ActiveDocument.getObject(%r)" % obj.Name


def _base(base):
    """Base geometry as Python has it; a whole sketch has no names, or an empty one."""
    pairs = ("(%s, %r)" % (_object(each), tuple(names) or "") for each, names in base)
    return "[%s]" % ", ".join(pairs)


def _value(obj, row):
    value = row.of(obj)
    if row.type == LINKS:
        return "[%s]" % ", ".join(map(_object, value))
    if row.type == SPEED:
        return repr("%.12g mm/min" % value)
    if row.type == POINT:
        return "FreeCAD.Vector(%r, %r, %r)" % tuple(value)
    return repr(value)
