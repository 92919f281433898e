# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: the toolbar's six steps and the menus, panels that follow one another and fit FreeCAD's dock,
and the guide: as mouse and keys reach them in a fresh profile."""

import itertools
import re
from pathlib import Path

import FreeCAD
import FreeCADGui
import pytest
from curveups.features.document import new_design
from curveups.window import guide as filters
from curveups.window.notice import with_links
from curveups.window.overlays import overlay_of
from curveups.window.run import LIVE
from PySide import QtCore, QtGui
from robot import (action, choose, click, click_at, close_panel, cut_off, display, keys, menu_bar, menu_of,
                   picture, press, scroll_to, settle, until, widget, window)
from running import ROOT
from steps import panel

pytestmark = pytest.mark.freecad(window=True)

F1 = "67"  # the code of the key: by its name xdotool presses Alt too, with keyboard maps of 2026
Qt_6 = int(QtCore.qVersion().split(".")[0]) > 5  # does not scale by the resolution of the 4K display
STEPS = ("NewDesign", "Check", "Solve", "Cuts", "Overlay", "Export")
PANELS = (("Check", "CheckPanel"), ("Cuts", "CutsPanel"), ("Overlay", "OverlayPanel"),
          ("WorstContacts", "WorstContactsPanel"), ("Actuate", "ActuatePanel"), ("Export", "ExportPanel"),
          ("Kit", "KitPanel"))


def begin():
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    window.move(0, 0)
    window.resize(1440, 900)
    settle(300)


def opened(path):
    begin()
    document = FreeCAD.openDocument(str(path))
    settle(500)
    return document.Design


def shown(kind):
    until(lambda: type(panel()).__name__ == kind and panel().form.isVisible(), 10, kind)
    until(lambda: not LIVE.busy, 60, "the run")
    settle(300)


def guide():
    """The paragraph that the guide is open at, and shows."""
    page = widget("page")
    settle(300)
    assert page.viewport().rect().contains(page.cursorRect().center())
    text = page.textCursor().block().text()
    page.window().close()
    settle(100)
    return text


def entries(menu):
    for one in menu.actions():
        below = menu_of(one)
        if below is not None:
            yield from entries(below)
        elif not one.isSeparator():
            yield one.objectName() or one.text()


def test_the_toolbar_has_the_six_steps_and_the_menu_has_everything(pictures):
    begin()
    bar = next(one for one in window.findChildren(QtGui.QToolBar) if one.windowTitle() == "CurveUps")
    actions = [one for one in bar.actions() if not one.isSeparator()]
    assert [one.objectName() for one in actions] == [f"CurveUps_{name}" for name in STEPS]
    top = next(one for one in window.menuBar().actions() if one.text() == "&CurveUps")
    found = list(entries(menu_of(top)))
    known = {name for name in FreeCADGui.listCommands() if name.startswith("CurveUps_")}
    assert not {name for name in known - set(found) if "Example" not in name}, found
    assert any("half" in name.lower() for name in found), found
    # Told apart at 24 pixels by brightness alone.
    images = [one.icon().pixmap(24, 24).toImage() for one in actions]
    grey = [[QtGui.qGray(image.pixel(x, y)) if QtGui.qAlpha(image.pixel(x, y)) > 99 else 240
             for x in range(24) for y in range(24)] for image in images]
    for k, first in enumerate(grey):
        for second in grey[:k]:
            assert sum(abs(a - b) > 40 for a, b in zip(first, second)) > 140
    picture("start")


def test_a_panel_takes_the_place_of_the_one_before(dome_document, pictures):
    design = opened(dome_document)
    for command, kind in (*PANELS, PANELS[0]):
        press(f"CurveUps_{command}")
        shown(kind)
    # A double click on the design does so, too; the check's picture goes with its panel.
    assert overlay_of(design).shows_target
    design.ViewObject.doubleClicked()
    shown("SolvePanel")
    assert not overlay_of(design).shows_target
    # One of another workbench is in the way until it is closed.
    close_panel()

    class Other:
        form = QtGui.QLabel("of another workbench")

    FreeCADGui.Control.showDialog(Other())
    settle(300)
    for command in STEPS[1:]:
        assert not FreeCADGui.Command.get(f"CurveUps_{command}").isActive(), command
    assert "Another task panel" in action("CurveUps_Check").statusTip()
    FreeCADGui.Control.closeDialog()
    settle(300)
    press("CurveUps_Overlay")
    shown("OverlayPanel")


def grey_without_reason(form):
    """Grey parts of a panel whose tooltip, or that of the grey part around them, doesn't say why."""
    found = []
    for one in form.findChildren(QtGui.QWidget):
        named = isinstance(one, (QtGui.QAbstractButton, QtGui.QSlider, QtGui.QAbstractSpinBox))
        if not named or not one.isVisible() or one.isEnabled():
            continue
        around = one
        while around.parentWidget() is not form and not around.parentWidget().isEnabled():
            around = around.parentWidget()
        if not (around.statusTip() and around.statusTip() in around.toolTip()):
            found.append((one.objectName(), around.objectName(), around.toolTip()))
    return found


def test_whatever_is_grey_says_why(dome_document, pictures):
    document = opened(dome_document).Document
    for design in (document.Design, new_design(document, "half-sphere")):  # solved, and empty
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(design)
        for command, kind in (*PANELS, ("Solve", "SolvePanel")):
            if not FreeCADGui.Command.get(f"CurveUps_{command}").isActive():
                assert action(f"CurveUps_{command}").statusTip()  # its reason
                continue
            press(f"CurveUps_{command}")
            until(lambda: type(panel()).__name__ == kind and panel().form.isVisible(), 10, kind)
            assert not grey_without_reason(panel().form), (kind, "at work")
            LIVE.cancel()
            shown(kind)
            picture(f"{design.Name}-{kind}")
            assert not grey_without_reason(panel().form), kind
    # What a click would say, the mouse says: over the grey button Stop.
    stop = panel().form.stop
    assert not stop.isEnabled()
    middle = stop.mapToGlobal(stop.rect().center())
    display("mousemove", middle.x() - 3, middle.y())
    display("mousemove", middle.x(), middle.y())
    tip = until(lambda: next((one for one in QtGui.QApplication.topLevelWidgets()
                              if one.metaObject().className() == "QTipLabel" and one.isVisible()), None),
                10, "the tooltip")
    assert "Nothing is at work" in tip.text()
    picture("grey")


def misfits(name, room):
    """What of a panel is wider than the room, or not seen whole."""
    form = panel().form
    picture(name)
    wide = [form.minimumSizeHint().width()] if form.minimumSizeHint().width() > room else []
    return [(name, one) for one in wide + cut_off(form)]


@pytest.mark.parametrize("language, theme, screen", [
    *itertools.product(["English", "German"], ["", "Dark-blue.qss"], ["usual"]),
    pytest.param("German", "Dark-blue.qss", "4K", marks=pytest.mark.freecad(window="4K"))])
def test_every_panel_fits_the_dock_that_a_fresh_profile_has(language, theme, screen, dome_document, pictures):
    if theme:
        sheet = Path(FreeCAD.getResourceDir()) / "Gui" / "Stylesheets" / theme
        if not sheet.exists():
            pytest.skip(f"this FreeCAD has no {theme}")
        QtGui.QApplication.instance().setStyleSheet(sheet.read_text("utf-8"))
    FreeCADGui.setLocale(language)
    try:
        design = opened(dome_document)
        assert screen == "usual" or window.devicePixelRatioF() == 2 or Qt_6
        dock = next(one for one in window.findChildren(QtGui.QDockWidget)
                    if one.isVisible() and one.objectName() in ("Combo View", "Tasks", "Model"))
        assert dock.width() < 300, dock.width()
        room = dock.width() - 46  # beside the frame of a panel and a scroll bar
        found = []
        for command, kind in PANELS:
            FreeCADGui.runCommand(f"CurveUps_{command}")
            shown(kind)
            if command == "Overlay":
                overlay_of(design).select_tiles([11])
                settle(300)
            found += misfits(f"{language}{theme}-{command}", room)
        design.ViewObject.doubleClicked()
        shown("SolvePanel")
        box = panel().form.group
        for number in range(box.count()):
            box.setCurrentIndex(number)
            settle(100)
            found += misfits(f"{language}{theme}-Solve-{number}", room)
        assert not found, "\n".join(map(str, found))
    finally:
        FreeCADGui.setLocale("English")


def test_the_guide_opens_from_the_menu_by_F1_and_by_links(dome_document, pictures):
    opened(dome_document)
    choose(lambda: menu_bar("CurveUps"), "Help", "Guide")
    assert guide() == "User guide"
    # F1 over a button and in a panel.
    button = next(one for one in window.findChildren(QtGui.QToolButton)
                  if one.isVisible() and one.defaultAction() == action("CurveUps_Cuts"))
    middle = button.mapToGlobal(button.rect().center())
    display("mousemove", middle.x(), middle.y())
    keys(F1)
    assert guide().startswith("Closed and deep surfaces need cuts")
    press("CurveUps_Export")
    shown("ExportPanel")
    click(panel().form.names)
    keys(F1)
    assert guide().startswith("Export Print Files")
    # What's This of a command, and a message that names one, have links.
    assert "guide:Solve" in action("CurveUps_Solve").whatsThis()
    QtGui.QApplication.sendEvent(window, QtGui.QWhatsThisClickedEvent("guide:Report"))
    assert "Report" in guide()
    assert with_links("there is no layout yet: Solve makes it").count('"guide:Solve"') == 1
    panel().form.line.linkActivated.emit("guide:Solver Status")
    assert guide().startswith("Solver Status shows")
    # PySide2 hands over a widget that had the event's address before.
    assert filters._keys.eventFilter(window, QtGui.QWidget()) is False


def test_the_guide_says_something_of_every_command():
    said = (ROOT / "resources" / "docs" / "guide.md").read_text(encoding="utf-8")
    for file in (ROOT / "Workbench" / "curveups" / "window" / "commands").glob("*.py"):
        for text in re.findall(r'text = QT_TRANSLATE_NOOP\("\w+", "([^"]+)"\)', file.read_text("utf-8")):
            assert f"**{text}**" in said, text


def click_link(label):
    """The first link of a rich text, where the mouse becomes a hand."""
    for y in range(8, label.height(), 9):
        for x in range(8, label.width(), 18):
            point = label.mapToGlobal(QtCore.QPoint(x, y))
            display("mousemove", point.x(), point.y())
            if label.cursor().shape() == QtCore.Qt.PointingHandCursor:
                return click_at(point)
    raise AssertionError("no link")


def test_whats_this_and_a_link_by_the_mouse(dome_document, pictures):
    """Shift+F1 makes the next click a question, which the guide answers: FreeCAD said that it had no help."""
    opened(dome_document)
    button = next(one for one in window.findChildren(QtGui.QToolButton)
                  if one.isVisible() and one.defaultAction() == action("CurveUps_Cuts"))
    keys(f"shift+{F1}")
    until(QtGui.QWhatsThis.inWhatsThisMode, 10, "What's This")
    click(button)
    picture("whats-this")
    assert guide().startswith("Closed and deep surfaces need cuts")
    assert not QtGui.QWhatsThis.inWhatsThisMode() and panel() is None
    # A message in a panel.
    press("CurveUps_Export")
    shown("ExportPanel")
    panel()._say(with_links("there is no layout yet: Solve makes it"))
    settle(300)
    picture("message")
    click_link(panel().form.line)
    assert "Solve" in guide()
    close_panel()


def test_the_live_curve_is_dark_on_dark_themes(pictures):
    begin()
    QtGui.QApplication.instance().setStyleSheet("QWidget { background: #2b2b2b; color: #dddddd; }")
    document = FreeCAD.newDocument("Dark")
    design = new_design(document, "half-sphere")
    design.L = 14
    document.recompute()
    press("CurveUps_Solve")
    shown("SolvePanel")
    curves = panel().curves
    scroll_to(curves, curves.rect().center())
    settle(500)
    picture("dark-curves")
    image = QtGui.QApplication.primaryScreen().grabWindow(0).toImage()
    corner = curves.mapToGlobal(QtCore.QPoint(0, 0))
    seen = [QtGui.QColor(image.pixel(corner.x() + x, corner.y() + y))
            for x in range(3, curves.width() - 3) for y in range(3, curves.height() - 3)]
    assert seen[0].name() == "#2b2b2b" and sum(one.name() == "#2b2b2b" for one in seen) > len(seen) / 2
    assert not any(one.name() == "#ffffff" for one in seen)
    assert any(one.name() == "#56b4e9" for one in seen), "no curve"
    close_panel()
