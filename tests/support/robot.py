# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouse, keys, waiting and pictures in FreeCAD's window. Only FreeCAD imports this module.

Mouse and keys are those of the display (xdotool): a test can't use parts that are covered, disabled or
without focus. Waiting runs the window's own event loop.
"""

import os
import re
import subprocess
import sys
import tempfile
import time

import FreeCADGui
from PySide import QtCore, QtGui

window = FreeCADGui.getMainWindow()
_pictures = tempfile.gettempdir()
_size = (1440, 900)


def keep_pictures_in(folder):
    global _pictures
    _pictures = str(folder)
    os.makedirs(_pictures, exist_ok=True)


def resize_to(width, height):
    """Set the size of the window for tidy()."""
    global _size
    _size = (width, height)


def settle(milliseconds=200):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(milliseconds, loop.quit)
    loop.exec_()


def until(condition, seconds=30, what=""):
    """Let the window work until the condition has a true value; return it."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            picture("timeout")
            raise AssertionError(f"waited {seconds} s for {what or condition}: " + report()[-1500:])
        settle(20)


def display(*arguments):
    """Run xdotool, at places in Qt's pixels. The window works meanwhile, since it answers the display, and
    has got all events in the end."""
    if arguments[0] == "mousemove":
        ratio = window.devicePixelRatioF()
        arguments = ("mousemove", *(round(ratio * place) for place in arguments[1:3]), *arguments[3:])
    running = subprocess.Popen(["xdotool", *map(str, arguments)])
    until(lambda: running.poll() is not None, 20, f"xdotool {arguments}")
    assert running.returncode == 0, arguments
    QtGui.QApplication.sync()
    settle(80)


def click_at(point, button=1, times=1):
    display("mousemove", point.x(), point.y())
    display("click", "--repeat", times, "--delay", 60, button)


def once_open(menu, act):
    """Act as soon as a menu is open, in the menu's own event loop."""
    def look():
        if menu.isVisible():
            QtCore.QTimer.singleShot(300, act)
        else:
            QtCore.QTimer.singleShot(50, look)

    look()


def scroll_to(widget, place):
    """Scroll a panel to a place in one of its widgets."""
    above = widget.parentWidget()
    while above is not None:
        if isinstance(above, QtGui.QScrollArea):
            at = widget.mapTo(above.widget(), place)
            above.ensureVisible(at.x(), at.y())
            settle(100)
        above = above.parentWidget()


def click_item(tree, item, column=0):
    """Click an item of a tree in a panel."""
    tree.scrollToItem(item)
    place = tree.visualRect(tree.indexFromItem(item, column)).center()
    scroll_to(tree.viewport(), place)
    click_at(tree.viewport().mapToGlobal(place))


def click(widget, times=1, button=1):
    scroll_to(widget, target_in(widget))
    assert widget.isVisible() and widget.isEnabled(), (widget.objectName(), widget.isVisible())
    click_at(at_rest_place(widget), button, times)


def target_in(widget):
    """Point of a widget to click: its middle, or the mark of a check box, whose text may be short."""
    middle = widget.rect().center()
    return QtCore.QPoint(10, middle.y()) if isinstance(widget, QtGui.QCheckBox) else middle


def at_rest_place(widget):
    """Point of a widget to click on the display, once layouts and scrolling have come to rest."""
    place, before = widget.mapToGlobal(target_in(widget)), None
    while place != before:
        settle(60)
        place, before = widget.mapToGlobal(target_in(widget)), place
    return place


def cut_off(form):
    """Texts below a widget that are cut off and in no tooltip, and panels that are wider than their dock."""
    misfits = [("too wide by", area.objectName(), area.horizontalScrollBar().maximum())
               for area in window.findChildren(QtGui.QScrollArea)
               if area.isAncestorOf(form) and area.horizontalScrollBar().maximum() > 0]
    for one in form.findChildren(QtGui.QWidget):
        if one.visibleRegion().isEmpty():
            continue
        if isinstance(one, QtGui.QLabel) and one.text():
            lacks = (one.heightForWidth(one.width()) > one.height() if one.wordWrap()
                     else one.sizeHint().width() > one.width())
        elif isinstance(one, QtGui.QAbstractSpinBox) and one.property("rawValue"):
            lacks = not re.search("[1-9]", one.text())
        elif isinstance(one, QtGui.QLineEdit):
            lacks = one.fontMetrics().horizontalAdvance(one.text() or one.placeholderText()) > one.width() - 4
        elif isinstance(one, QtGui.QComboBox):
            option = QtGui.QStyleOptionComboBox()
            one.initStyleOption(option)
            field = one.style().subControlRect(QtGui.QStyle.CC_ComboBox, option,
                                               QtGui.QStyle.SC_ComboBoxEditField, one)
            lacks = one.fontMetrics().horizontalAdvance(one.currentText()) > field.width()
        elif isinstance(one, QtGui.QAbstractButton):
            lacks = one.sizeHint().width() > one.width()
        elif isinstance(one, QtGui.QTreeWidget):
            lacks = False
            misfits += [("QTreeWidget", one.objectName(), text) for text in _cut_off_in(one)]
        elif isinstance(one, QtGui.QTableWidget):
            lacks = one.horizontalScrollBar().maximum() > 0
        else:
            continue
        text = getattr(one, "text", lambda: "")() or getattr(one, "currentText", lambda: "")()
        if lacks and (not text or text not in one.toolTip()):
            misfits.append((type(one).__name__, one.objectName(), text))
    return misfits


def texts(form):
    """All visible texts below a widget."""
    for one in form.findChildren(QtGui.QWidget):
        if one.isVisible():
            kinds = ("text", "currentText", "title")
            yield from (getattr(one, kind)() for kind in kinds if hasattr(one, kind))
            if isinstance(one, QtGui.QTreeWidget):
                yield from (item.text(column) for item in (one.headerItem(), *rows_of(one))
                            for column in range(one.columnCount()))


def rows_of(tree):
    """All items of a tree."""
    items = [tree.topLevelItem(row) for row in range(tree.topLevelItemCount())]
    for item in items:
        items += map(item.child, range(item.childCount()))
    return items


def _cut_off_in(tree):
    """Texts of a tree that are cut off and not in their tooltips."""
    seen = tree.viewport().width()
    for item in [*rows_of(tree), *([] if tree.isHeaderHidden() else [tree.headerItem()])]:
        for column in range(1 if item.isFirstColumnSpanned() else tree.columnCount()):
            room = seen if item.isFirstColumnSpanned() else min(
                tree.columnWidth(column), seen - tree.columnViewportPosition(column))
            wide = max(map(tree.fontMetrics().horizontalAdvance, item.text(column).split("\n")))
            if wide > room - 4 and item.text(column) not in item.toolTip(column):
                yield f"{item.text(column)!r}: {wide} of {room}"


def keys(*names):
    top = QtGui.QApplication.activeWindow() or window
    display("windowfocus", int(top.winId()))
    display("key", *names)


def write(text):
    display("type", "--delay", 15, "--", text)


def fill(box, text):
    """Type over the text of a spin box or a line, and leave it."""
    click(box, times=3)
    keys("ctrl+a")
    write(text)
    keys("Tab")


def widget(name, seconds=10):
    """The visible widget of that object name, in the window or in a dialog."""

    def find():
        for top in QtGui.QApplication.topLevelWidgets():
            for child in top.findChildren(QtGui.QWidget, name) if top.isVisible() else ():
                if child.isVisible():
                    # PySide drops what it knows of the widgets in a dialog together with the dialog. Nobody
                    # else keeps that: it would take later widgets at its address for those that are gone.
                    child.dialog = top
                    return child
        return None

    return until(find, seconds, f"a widget {name}")


def in_dialog(start, work):
    """Call work() in the modal dialog that start() opens. work() closes it."""
    _while_open(QtGui.QApplication.activeModalWidget, start, work, "a dialog")
    until(lambda: QtGui.QApplication.activeModalWidget() is None, 30, "the dialog to close")


def choose(start, *texts):
    """Click entries that begin with these texts in the menu that start() opens, those of a submenu last."""

    def menu():
        popup = QtGui.QApplication.activePopupWidget()
        return popup if isinstance(popup, QtGui.QMenu) else None

    def work():
        for text in texts:
            opened = until(menu, 3, f"the menu with {text}")
            entries = {entry.text().replace("&", ""): entry for entry in opened.actions()}
            entry = next((entry for name, entry in entries.items() if name.startswith(text)), None)
            assert entry is not None and entry.isEnabled(), (text, list(entries))
            click_at(opened.mapToGlobal(opened.actionGeometry(entry).center()))

    _while_open(menu, start, work, "a menu")
    settle(100)


def _while_open(opened, start, work, what):
    """Call work() once opened() is there, in the event loop of what start() opens. It is closed after a
    failure, which is raised in the end."""
    errors: list[BaseException] = []
    timer = QtCore.QTimer()

    def look():
        if not opened():
            return
        timer.stop()
        try:
            settle(300)
            work()
        except BaseException as error:
            errors.append(error)
            while opened():
                opened().close()

    timer.timeout.connect(look)
    timer.start(50)
    start()
    until(lambda: not timer.isActive(), 30, what)
    if errors:
        raise errors[0]


def menu_bar(title):
    """Open a menu of the window, as the start of choose()."""
    bar = window.menuBar()
    entry = next(one for one in bar.actions() if one.text().replace("&", "") == title)
    click_at(bar.mapToGlobal(bar.actionGeometry(entry).center()))


def tree_entry(obj):
    """Point of an object's row in the tree, on the display."""
    for tree in window.findChildren(QtGui.QTreeWidget):
        for item in tree.findItems(obj.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive):
            if tree.isVisible() and item.text(0) == obj.Label:
                tree.scrollToItem(item)
                settle(100)
                rect = tree.visualItemRect(item)
                rect.setLeft(min(rect.left() + 58, rect.right()))  # past the eye and the icon
                return tree.viewport().mapToGlobal(QtCore.QPoint(rect.left(), rect.center().y()))
    raise AssertionError(f"{obj.Label} is not in the tree")


def choose_file(path):
    """Choose a file in a dialog. A first Return may take a folder that the dialog proposes."""
    dialog = QtGui.QApplication.activeModalWidget()
    for _ in range(3):
        keys("ctrl+a")
        write(path)
        keys("Return")
        settle(300)
        if QtGui.QApplication.activeModalWidget() is not dialog:
            return


def action(command):
    return FreeCADGui.Command.get(command).getAction()[0]


def entry_of(*commands):
    """Text in menus of the first of these commands that this version of FreeCAD has."""
    return next(action(one).text().replace("&", "") for one in commands if one in FreeCADGui.listCommands())


def menu_of(entry):
    """The menu that an entry opens, or None. PySide's QAction.menu() may delete the menu together with its
    Python object."""
    return next((one for one in window.findChildren(QtGui.QMenu) if one.menuAction() == entry), None)


def press(command):
    """Click the command's button in the toolbar, or its entry in the menu CurveUps."""
    wanted = action(command)
    until(wanted.isEnabled, 10, f"{command} to be active")
    for button in window.findChildren(QtGui.QToolButton):
        if button.defaultAction() is wanted or button.defaultAction() == wanted:
            if button.isVisible():
                return click(button)

    def way(menu):
        for one in menu.actions():
            below = menu_of(one)
            rest = way(below) if below is not None else [] if one == wanted else None
            if rest is not None:
                return [one.text().replace("&", ""), *rest]
        return None

    texts = way(menu_of(next(one for one in window.menuBar().actions() if one.text() == "&CurveUps")))
    assert texts, f"{command} has neither a button nor an entry"
    choose(lambda: menu_bar("CurveUps"), *texts)


def close_panel():
    """Close the task panel by its button."""
    if FreeCADGui.Control.activeDialog():
        click(next(button for box in window.findChildren(QtGui.QDialogButtonBox) if box.isVisible()
                   for button in [box.button(QtGui.QDialogButtonBox.Close)] if button))
        until(lambda: not FreeCADGui.Control.activeDialog(), 10, "the panel to close")


def report():
    view = window.findChild(QtGui.QTextEdit, "Report view")
    return view.toPlainText() if view else ""


def clear_report():
    view = window.findChild(QtGui.QTextEdit, "Report view")
    if view:
        view.clear()


def at_rest(seconds=120):
    """Wait until no run of the window is at work, nor settled forces that follow it."""
    run = sys.modules.get("curveups.window.run")
    until(lambda: run is None or not (run.WORKER.busy or run.LIVE.waiting), seconds, "the run to end")
    settle(200)


def picture(name):
    """Keep a picture of the display; return the number of colours in the middle of the 3D view."""
    settle(150)
    image = QtGui.QApplication.primaryScreen().grabWindow(0).toImage()
    image.save(os.path.join(_pictures, name + ".png"))
    area, ratio = window.findChild(QtGui.QMdiArea), window.devicePixelRatioF()
    corner = area.mapToGlobal(QtCore.QPoint(0, 0)) * ratio
    wide, high = int(area.width() * ratio), int(area.height() * ratio)
    return len({image.pixel(corner.x() + wide * column // 80, corner.y() + high * row // 80)
                for column in range(16, 64) for row in range(16, 64)})


def on_screen(point, view=None):
    """Point on the display of a point in space (FreeCAD.Vector)."""
    view = view or FreeCADGui.ActiveDocument.ActiveView
    place = getattr(view, "getPointOnViewport", None) or view.getPointOnScreen
    x, y = place(point)
    views = window.findChild(QtGui.QMdiArea)
    shown = views.activeSubWindow()  # kept while its child is used: PySide 2 may let go of both together
    # The view fills this. PySide would keep what it knows of the QGraphicsView beyond its end, and take the
    # next one at its address for that.
    area = shown.widget()
    ratio = area.devicePixelRatioF()
    return area.mapToGlobal(QtCore.QPoint(int(x / ratio), area.height() - 1 - int(y / ratio)))


def tidy():
    """Let the window fill the display, with only tree, properties, tasks and report view beside the views."""
    window.move(0, 0)
    window.resize(*_size)
    for dock in window.findChildren(QtGui.QDockWidget):
        name = dock.objectName()
        dock.setVisible(name in ("Combo View", "Tasks", "Model", "Tree view", "Property view", "Report view"))
        if name == "Report view":
            window.resizeDocks([dock], [90], QtCore.Qt.Vertical)
        elif dock.isVisible():
            window.resizeDocks([dock], [340], QtCore.Qt.Horizontal)
    settle(300)
