# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles that carry the design, picked by the mouse: one by one, by a stroke, and by growing a patch."""

import FreeCAD
import FreeCADGui
import pytest
from curveups.window.overlays import overlay_of
from robot import click, click_at, display, keys, on_screen, picture, QtGui, settle, until, widget, window
from steps import opened, panel

pytestmark = pytest.mark.freecad(window=True)


def middle(design, tile):
    """Where a tile is on the display."""
    return on_screen(FreeCAD.Vector(*map(float, overlay_of(design).figures()[0][0][tile, :3].mean(0))))


def held(design):
    return [int(name[1:]) - 1 for name in design.HeldTiles.split(",") if name]


def undo(design, tiles):
    FreeCADGui.runCommand("Std_Undo")
    until(lambda: held(design) == tiles, 10, f"undo to {tiles}")


def test_tiles_are_held_by_click_stroke_and_growth(dome_document, pictures):
    document, design = opened(dome_document)
    design.ViewObject.Visibility = True
    design.Tiles.Visibility = design.Support.Visibility = design.Anchors.Visibility = False
    design.ViewObject.doubleClicked()
    until(lambda: panel() is not None and panel().form.isVisible(), 10, "the panel")
    form = panel().form
    if not form.all.isChecked():
        panel().turn_to("Physics")
        form.all.setChecked(True)
    panel().turn_to("Physics")
    settle(300)
    assert not [one for one in QtGui.QApplication.topLevelWidgets()
                if one.isVisible() and one.findChild(QtGui.QWidget, "FrictionCoefficient")
                and one is not window], "rows of before float about"
    button = widget("pick_held_tiles")
    assert not button.isEnabled() and "Gravity" in button.toolTip()
    design.Gravity = "held"
    document.recompute()
    until(button.isEnabled, 10, "the button")
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    settle(500)
    click(button)
    F = overlay_of(design).scene.F
    around = sorted({tile for tile in range(len(F)) if set(F[tile]) & set(F[0])})
    far = next(tile for tile in range(len(F)) if not set(F[tile]) & set(F[around].ravel()))
    # One by one; a second click releases.
    for tile, expected in ((0, [0]), (far, [0, far]), (far, [0])):
        click_at(middle(design, tile))
        until(lambda: held(design) == expected, 10, f"a click to give {expected}")
    assert widget("HeldTiles").text() == "T00001" and overlay_of(design).selected == [0]
    # A patch grows by what is around it; the far tile is another patch.
    click_at(middle(design, far))
    display("keydown", "ctrl")
    click_at(middle(design, 0))
    display("keyup", "ctrl")
    grown = sorted({*around, far})
    until(lambda: held(design) == grown, 10, f"growth to {grown}, not {held(design)}")
    picture("grown")
    undo(design, sorted([0, far]))
    undo(design, [0])
    # A stroke is one step of undo.
    neighbour = next(tile for tile in around if len(set(F[tile]) & set(F[0])) == 2)
    start, end = middle(design, 0), middle(design, neighbour)
    display("keydown", "shift")
    display("mousemove", start.x(), start.y(), "mousedown", 1)
    display("mousemove", (start.x() + end.x()) // 2, (start.y() + end.y()) // 2)
    display("mousemove", end.x(), end.y())
    display("mouseup", 1)
    display("keyup", "shift")
    until(lambda: held(design) == sorted([0, neighbour]), 10, f"the stroke, not {held(design)}")
    undo(design, [0])
    # Escape gives the mouse back.
    view = middle(design, far)
    display("mousemove", view.x(), view.y())
    FreeCADGui.ActiveDocument.ActiveView.graphicsView().setFocus()
    keys("Escape")
    until(lambda: not button.isChecked(), 10, "the end of picking")
    click_at(view)
    settle(300)
    assert held(design) == [0]
    assert overlay_of(design).selected == [far]
