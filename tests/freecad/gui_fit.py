"""Whether panels fit into a narrow dock: for scripts that tests run in FreeCAD's GUI."""

import FreeCADGui
from gui_tools import later, panel_buttons, widgets
from PySide import QtCore, QtGui

MARGIN = 2  # pixels of an edit field on either side of its text


def dock_of(page):
    """The dock that a panel is in. Not by way of the parents: Python would keep them, and what is
    in them, beyond their time.
    """
    return next(each for each in widgets(QtGui.QDockWidget) if each.isAncestorOf(page.form))


def lies_over_the_view(page):
    """Whether a panel lies over the 3D view, as FreeCAD 1.1 has it at first."""
    return any(
        each.isAncestorOf(page.form)
        for each in widgets(QtGui.QTabWidget)
        if each.metaObject().className() == "Gui::OverlayTabWidget"
    )


def resize_dock(page, width):
    """Gives the dock of a panel a width. Over the 3D view a script cannot: it is put beside it."""
    window = FreeCADGui.getMainWindow()
    if lies_over_the_view(page):
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, dock_of(page))
        dock_of(page).show()
    window.resizeDocks([dock_of(page)], [width], QtCore.Qt.Horizontal)
    later()


def right_of(widget):
    return widget.mapToGlobal(QtCore.QPoint(widget.width(), 0)).x()


def shown_of(widget):
    """Pixels of a widget's width that show: FreeCAD's panels scroll downwards alone, and what is
    wider than its dock is cut off.
    """
    return widget.visibleRegion().boundingRect().right() + 1


def text_room(field):
    """(the text that a field shows, pixels that it has for it); None for a field without text."""
    if isinstance(field, QtGui.QComboBox):
        option = QtGui.QStyleOptionComboBox()
        field.initStyleOption(option)
        style = field.style()
        part = QtGui.QStyle.SC_ComboBoxEditField
        room = style.subControlRect(QtGui.QStyle.CC_ComboBox, option, part, field)
        return field.currentText(), room.width()
    edit = field if isinstance(field, QtGui.QLineEdit) else field.findChild(QtGui.QLineEdit)
    if edit is None:
        return None
    icons = [each for each in edit.findChildren(QtGui.QLabel) if each.isVisible()]
    room = min([edit.width(), *(each.x() for each in icons)])
    return edit.text() or edit.placeholderText(), room - 2 * MARGIN


def cut_off_buttons(box):
    """The texts of a panel's buttons that have no room in them."""
    kinds = QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Cancel, QtGui.QDialogButtonBox.Apply
    found, contents = [], QtGui.QStyle.SE_PushButtonContents
    for button in map(box.button, kinds):
        option = QtGui.QStyleOptionButton()
        button.initStyleOption(option)
        room = button.style().subElementRect(contents, option, button).width()
        icon = 0 if option.icon.isNull() else option.iconSize.width()
        if QtGui.QFontMetrics(button.font()).boundingRect(option.text).width() + icon > room:
            found.append(option.text)
    return found


def too_wide(page):
    """Names of what does not fit into the dock, among fields, labels and their texts."""
    viewport, found = page.area.viewport(), []
    texts = {"controller": page.form.toolController, "coolant": page.form.coolantController}
    if page.engagement:
        texts["share"] = page.engagement.share
    for name, widget in page.widgets.items():
        label = page.labels[name]
        for part in (widget, label):
            if part.isVisible() and right_of(part) > right_of(viewport):
                found.append(name)
        if label.isVisible() and label.width() < label.sizeHint().width():
            found.append("label of " + name)
        boxes = page.points.get(name, [widget])
        texts.update({"%s %d" % (name, number): box for number, box in enumerate(boxes)})
    for name, field in texts.items():
        text, room = text_room(field) or ("", 0)
        if field.isVisible() and QtGui.QFontMetrics(field.font()).boundingRect(text).width() > room:
            found.append("text of " + name)
    buttons = panel_buttons()
    for name, widget in (("the page", page.form), ("the buttons", buttons)):
        if shown_of(widget) < widget.width():
            found.append("the right of " + name)
    if buttons.minimumSizeHint().width() > buttons.width():
        found.append("the buttons, which lie one over the other")
    found += ["the text of the button " + text for text in cut_off_buttons(buttons)]
    for label in page.status.top.findChildren(QtGui.QLabel):
        if label.isVisible() and label.height() < label.heightForWidth(label.width()):
            found.append("a line of the status: " + label.text())
    if page.area.horizontalScrollBar().maximum() > 0:
        found.append("the width of the page")
    return found
