# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD with a window, on a virtual display: the workbench registers, the document shows as it was
made, and is edited as users do it."""

import os
import re

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import actions, document as documents
from curveups.window.overlays import overlay_of
from robot import settle, until

pytestmark = pytest.mark.freecad(window=True)


def opened(path):
    document = FreeCAD.openDocument(str(path))
    settle()
    return document, FreeCADGui.getDocument(document.Name)


def colour(view):
    """Since FreeCAD 1.0 it is in the appearance."""
    rgb = view.ShapeColor if hasattr(view, "ShapeColor") else view.ShapeAppearance[0].DiffuseColor
    return tuple(rgb[:3])


def step_colours(folder):
    """The colours in the print's STEP file, each as three numbers from 0 to 1."""
    text = (folder / "dome-print.step").read_text(encoding="utf-8")
    return {tuple(map(float, match)) for match in
            re.findall(r"COLOUR_RGB\('',([\d.E+-]+),([\d.E+-]+),([\d.E+-]+)\)", text)}


def test_document_in_a_window(capfd, dome_document, tmp_path):
    picture, copy = tmp_path / "view.png", str(tmp_path / "copy.FCStd")
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    assert FreeCADGui.activeWorkbench().MenuText == "CurveUps"
    assert os.path.isfile(FreeCADGui.activeWorkbench().Icon)
    document, gui = opened(dome_document)
    view = gui.getObject
    shown = {name: (document.getObject(name).Visibility, view(name).Visibility)
             for name in ("Target", "Tiles", "Support", "Anchors")}
    assert shown == {"Target": (False, False), "Tiles": (True, True), "Support": (False, False),
                     "Anchors": (True, True)}, shown
    assert type(view("Design").Proxy).__name__ == "DesignView"
    assert not view("Design").Proxy.getIcon().isNull()
    assert [child.Name for child in view("Design").Proxy.claimChildren()] == [
        "Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors"]
    assert view("Tiles").DisplayMode == "Shaded"
    colours = [colour(view(name)) for name in ("Tiles", "Support", "Anchors")]
    view3d = gui.activeView()
    view3d.saveImage(str(picture), 800, 600, "White")
    view("Support").Visibility = True
    view("Tiles").Visibility = False
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    again = FreeCADGui.getDocument(FreeCAD.openDocument(copy).Name)
    assert again.getObject("Support").Visibility and not again.getObject("Tiles").Visibility
    out = "".join(capfd.readouterr())
    assert "does not support" not in out and "Traceback" not in out, out
    # Not blank, without anything having been moved: a picture of tiles does not compress to nothing.
    assert picture.stat().st_size > 20_000
    expected = step_colours(dome_document.parent)
    assert len(set(colours)) == 3
    for rgb in colours:
        assert any(max(abs(a - b) for a, b in zip(rgb, e)) < 1e-6 for e in expected), (rgb, expected)


def save_a_copy(path, copy):
    """Without the workbench."""
    opened(path)[0].saveAs(str(copy))


def test_it_is_drawn_again_after_a_save_without_the_workbench(elsewhere, tmp_path):
    own, foreign, picture = tmp_path / "own.FCStd", tmp_path / "foreign.FCStd", tmp_path / "view.png"
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    made = FreeCAD.newDocument("Made")
    design = documents.new_design(made, "half-sphere")
    design.L = 14
    actions.solve(design)
    made.recompute()
    made.saveAs(str(own))
    FreeCAD.closeDocument(made.Name)
    elsewhere(save_a_copy, own, foreign, home="nothing", window=True)
    document, gui = opened(foreign)
    settle(800)
    view = gui.getObject("Design")
    assert view.Visibility and view.DisplayMode == "Tiles" and view.SwitchNode.whichChild.getValue() == 0
    gui.activeView().viewTop()
    gui.activeView().fitAll()
    gui.activeView().saveImage(str(picture), 800, 600, "White")
    FreeCADGui.Selection.addSelection(document.Design)
    settle(500)
    command = FreeCADGui.Command.get("CurveUps_ShowActuated")
    assert command.isActive(), command.getAction()[0].statusTip()
    document.Design.Tau = 2.5  # it follows
    document.recompute()
    until(lambda: overlay_of(document.Design).legend.content.faded, 10, "the legend to follow")
    assert picture.stat().st_size > 10_000  # a blank view is a fraction of that
