# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: the toolbar's steps and the menus, panels that follow one another and fit FreeCAD's dock,
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
STEPS = ("NewDesign", "Check", "Solve", "Verify", "Cuts", "Overlay", "Export")
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
    for entry in menu.actions():
        below = menu_of(entry)
        if below is not None:
            yield from entries(below)
        elif not entry.isSeparator():
            yield entry.objectName() or entry.text()


def test_the_toolbar_has_the_steps_and_the_menu_has_everything(pictures):
    begin()
    bar = next(bar for bar in window.findChildren(QtGui.QToolBar) if bar.windowTitle() == "CurveUps")
    actions = [entry for entry in bar.actions() if not entry.isSeparator()]
    assert [entry.objectName() for entry in actions] == [f"CurveUps_{name}" for name in STEPS]
    top = next(entry for entry in window.menuBar().actions() if entry.text() == "&CurveUps")
    names = list(entries(menu_of(top)))
    known = {name for name in FreeCADGui.listCommands() if name.startswith("CurveUps_")}
    assert not {name for name in known - set(names) if "Example" not in name}, names
    assert any("half" in name.lower() for name in names), names
    # Told apart at 24 pixels by brightness alone.
    images = [entry.icon().pixmap(24, 24).toImage() for entry in actions]
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
    unexplained = []
    for part in form.findChildren(QtGui.QWidget):
        named = isinstance(part, (QtGui.QAbstractButton, QtGui.QSlider, QtGui.QAbstractSpinBox))
        if not named or not part.isVisible() or part.isEnabled():
            continue
        around = part
        while around.parentWidget() is not form and not around.parentWidget().isEnabled():
            around = around.parentWidget()
        if not (around.statusTip() and around.statusTip() in around.toolTip()):
            unexplained.append((part.objectName(), around.objectName(), around.toolTip()))
    return unexplained


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
    # What a click would say, the mouse says: over the grey button Verify.
    verify = panel().form.verify
    assert not verify.isEnabled()
    middle = verify.mapToGlobal(verify.rect().center())
    display("mousemove", middle.x() - 3, middle.y())
    display("mousemove", middle.x(), middle.y())
    tip = until(lambda: next((top for top in QtGui.QApplication.topLevelWidgets()
                              if top.metaObject().className() == "QTipLabel" and top.isVisible()), None),
                10, "the tooltip")
    assert "There is no layout yet" in tip.text()
    picture("grey")


def misfits(name, room):
    """Parts of a panel that are wider than the room, or cut off."""
    form = panel().form
    picture(name)
    wide = [form.minimumSizeHint().width()] if form.minimumSizeHint().width() > room else []
    return [(name, misfit) for misfit in wide + cut_off(form)]


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
        dock = next(dock for dock in window.findChildren(QtGui.QDockWidget)
                    if dock.isVisible() and dock.objectName() in ("Combo View", "Tasks", "Model"))
        assert dock.width() < 300, dock.width()
        room = dock.width() - 46  # beside the frame of a panel and a scroll bar
        wrong = []
        for command, kind in PANELS:
            FreeCADGui.runCommand(f"CurveUps_{command}")
            shown(kind)
            if command == "Overlay":
                overlay_of(design).select_tiles([11])
                settle(300)
            wrong += misfits(f"{language}{theme}-{command}", room)
        design.ViewObject.doubleClicked()
        shown("SolvePanel")
        box = panel().form.group
        for number in range(box.count()):
            box.setCurrentIndex(number)
            settle(100)
            wrong += misfits(f"{language}{theme}-Solve-{number}", room)
        assert not wrong, "\n".join(map(str, wrong))
    finally:
        FreeCADGui.setLocale("English")


def test_the_guide_opens_from_the_menu(dome_document, pictures):
    opened(dome_document)
    choose(lambda: menu_bar("CurveUps"), "Help", "Guide")
    page = widget("CurveUpsGuide")
    assert page.toPlainText().startswith("User guide")
    page.window().close()


def test_the_guide_says_something_of_every_command():
    said = (ROOT / "resources" / "docs" / "guide.md").read_text(encoding="utf-8")
    assert not [command.text for command in COMMANDS
                if command.icon == "" and f"**{command.text}**" not in said]
