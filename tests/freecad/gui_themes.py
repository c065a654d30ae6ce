"""FreeCAD's themes, for scripts that tests run in its GUI: style sheets of 0.20, and since 1.0
preference packs, which set a style sheet, what it is filled with, and colours.
"""

import glob
import os
import re
import xml.etree.ElementTree as ElementTree

import FreeCAD
from gui_tools import later
from PySide import QtCore, QtGui

SETTINGS = "User parameter:"
MAIN = SETTINGS + "BaseApp/Preferences/MainWindow"
PACKS = os.path.join(FreeCAD.getResourceDir(), "Gui", "PreferencePacks", "*", "*.cfg")
SETTERS = {
    "FCText": ("SetString", str),
    "FCBool": ("SetBool", lambda value: value == "1"),
    "FCInt": ("SetInt", int),
    "FCUInt": ("SetUnsigned", int),
    "FCFloat": ("SetFloat", float),
}


def themes():
    """The names of all themes that FreeCAD brings along. Of style sheets that differ by the colour
    of what is selected one is enough; '' is none.
    """
    if _packs():
        return sorted(_packs())
    found = QtCore.QDir("qss:").entryList(["*.qss"])
    return ["", *(name for name in found if not re.search("-(green|orange)[.]", name))]


def take(theme):
    """Shows a theme, as FreeCAD does where its user takes it in the preferences."""
    if _packs():
        _take_pack(_packs()[theme])
    else:
        _take_style_sheet(theme)
    later(600)


def _packs():
    """{the theme: the file} of preference packs that are a theme."""
    found = {}
    for file in glob.glob(PACKS):
        names = [value for _, name, _, value in _values_in(file) if name == "Theme"]
        found.update({name: file for name in names})
    return found


def _values_in(file):
    """(path of the group, name, kind, text) of all values of a file of parameters."""
    (root,) = ElementTree.parse(file).getroot()
    return _values_of(root, ())


def _values_of(group, path):
    for each in group:
        if each.tag == "FCParamGroup":
            yield from _values_of(each, (*path, each.get("Name")))
        else:
            text = each.text or "" if each.tag == "FCText" else each.get("Value")
            yield "/".join(path), each.get("Name"), each.tag, text


def _take_pack(file):
    for path, name, kind, text in _values_in(file):
        setter, read = SETTERS[kind]
        getattr(FreeCAD.ParamGet(SETTINGS + path), setter)(name, read(text))
    for macro in glob.glob(os.path.join(glob.escape(os.path.dirname(file)), "post.FCMacro")):
        with open(macro) as program:
            exec(program.read(), {})


def _take_style_sheet(name):
    FreeCAD.ParamGet(MAIN).SetString("StyleSheet", name)
    file = QtCore.QFile("qss:" + name)
    text = ""
    if name and file.open(QtCore.QFile.ReadOnly):
        text = bytes(file.readAll()).decode()
    QtGui.QApplication.instance().setStyleSheet(text)
