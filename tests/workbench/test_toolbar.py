# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: the toolbar's six steps and the menus, panels that follow one another and fit FreeCAD's dock,
and the guide, in a fresh profile."""

from pathlib import Path

import FreeCAD
import FreeCADGui
import pytest
from curveups.features.document import new_design
from curveups.window.commands import COMMANDS
from curveups.window.overlays import overlay_of
from curveups.window.run import LIVE
from PySide import QtCore, QtGui
from robot import (action, choose, close_panel, cut_off, display, menu_bar, menu_of, picture, press, settle,
                   until, widget, window)
from running import ROOT
from steps import panel

pytestmark = pytest.mark.freecad(window=True)

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


@pytest.mark.all
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
    """Parts of a panel that are wider than the room, or cut off."""
    form = panel().form
    picture(name)
    wide = [form.minimumSizeHint().width()] if form.minimumSizeHint().width() > room else []
    return [(name, one) for one in wide + cut_off(form)]


@pytest.mark.parametrize("language, theme, screen", [
    ("German", "", "usual"),
    pytest.param("English", "Dark-blue.qss", "usual", marks=pytest.mark.all),
    pytest.param("German", "Dark-blue.qss", "4K", marks=[pytest.mark.all, pytest.mark.freecad(window="4K")])])
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


def test_the_guide_opens_from_the_menu(dome_document, pictures):
    opened(dome_document)
    choose(lambda: menu_bar("CurveUps"), "Help", "Guide")
    page = widget("page")
    assert page.toPlainText().startswith("User guide")
    page.window().close()


def test_the_guide_says_something_of_every_command():
    said = (ROOT / "resources" / "docs" / "guide.md").read_text(encoding="utf-8")
    assert not [command.text for command in COMMANDS
                if command.icon == "" and f"**{command.text}**" not in said]
