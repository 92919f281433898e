# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way of a user, by mouse and keys in a real window: from a mesh file to print files, with what
goes wrong on the way. The pictures of it are kept in build/whole-way, to be looked at."""

import os
import shutil

import FreeCAD
import FreeCADGui
import Mesh
import pytest
from curveups.features import document as documents
from curveups.window.overlays import overlay_of
from robot import (choose_file, click, click_at, close_panel, fill, in_dialog, keep_pictures_in, keys,
                   on_screen, picture, press, report, settle, tidy, until, widget)
from running import ROOT, dome
from steps import LIVE

pytestmark = [pytest.mark.freecad(window=True), pytest.mark.all]


def design():
    return next(obj for obj in FreeCAD.ActiveDocument.Objects
                if getattr(obj, "CurveUpsType", "").endswith("Design"))


def idle(seconds=120):
    until(lambda: not LIVE.busy, seconds, "the run to end")
    settle(300)


def select(obj):
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(obj)
    settle(200)


def again_until(combination, condition, what):
    """Typing that pauses on a busy machine is several edits, each a step of undo."""
    for _ in range(4):
        if condition():
            return
        keys(combination)
        settle(800)
    assert condition(), what


def open_a_mesh(folder):
    in_dialog(lambda: keys("ctrl+o"), lambda: choose_file(str(folder / "dome.stl")))
    until(lambda: FreeCAD.ActiveDocument and FreeCAD.ActiveDocument.Objects, 30, "the mesh")
    surface, = FreeCAD.ActiveDocument.Objects
    assert surface.isDerivedFrom("Mesh::Feature")
    assert picture("01-mesh") > 5


def new_design(folder):
    surface = FreeCAD.ActiveDocument.Objects[0]
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    settle(300)
    click_at(on_screen(surface.Mesh.BoundBox.Center))
    assert FreeCADGui.Selection.getSelection() == [surface]
    press("CurveUps_NewDesign")
    until(lambda: len(FreeCAD.ActiveDocument.Objects) > 1, 20, "the design")
    settle(300)
    assert design().Target.Source == surface, design().Target.Source
    assert design().Status == "empty", (design().Status, list(design().Reasons))
    surface.ViewObject.Visibility = False
    picture("02-new-design")


def place_a_cut(folder):
    """An edge from the rim inwards, by one click on the target; a second click there takes it back."""
    select(design())
    press("CurveUps_Cuts")
    until(lambda: not LIVE.busy and overlay_of(design()).scene is not None, 60, "the target")
    view = FreeCADGui.ActiveDocument.ActiveView
    view.viewTop()
    view.fitAll()
    settle(500)
    picture("03-target")
    place = on_screen(FreeCAD.Vector(0, 25, 0))
    click_at(place)
    until(lambda: len(documents.cuts_of(design())), 20, "a cut")
    until(lambda: not LIVE.busy, 60, "the layout")
    assert picture("04-cut") > 5
    again_until("ctrl+z", lambda: not len(documents.cuts_of(design())), "undo of the cut")
    close_panel()


def solve_live(folder):
    select(design())
    press("CurveUps_Solve")
    idle()
    assert design().Verdict == "valid", (design().Verdict, list(design().Reasons))
    assert design().TileCount > 50
    assert picture("05-solved") > 12
    assert not widget("stop").isEnabled()
    close_panel()


def change_thickness(folder):
    """In the panel, by the keys; then undo and redo."""
    before = design().HBody.Value
    FreeCADGui.ActiveDocument.setEdit(design().Name)
    group = widget("group")
    group.setCurrentText("Tiles")
    settle(200)
    fill(widget("HBody"), "2.8")
    until(lambda: abs(design().HBody.Value - 2.8) < 1e-9, 10, "the thickness")
    assert design().Verdict != "valid", "a stale verdict"
    picture("06-thicker")
    close_panel()
    settle(500)
    again_until("ctrl+z", lambda: design().HBody.Value == before, "undo")
    assert design().Verdict == "valid", (design().Verdict, list(design().Reasons))
    again_until("ctrl+shift+z", lambda: abs(design().HBody.Value - 2.8) < 1e-9, "redo")
    picture("07-redone")


def verify(folder):
    select(design())
    press("CurveUps_Verify")
    idle()
    assert design().Verdict in ("valid", "not valid"), design().Verdict
    assert design().Status in ("current", "invalid"), design().Status
    picture("08-verified")
    close_panel()


def repair(folder):
    select(design())
    press("CurveUps_Repair")
    idle()
    assert design().Verdict == "valid", (design().Verdict, list(design().Reasons))
    picture("09-repaired")
    close_panel()


def refused_value(folder):
    FreeCADGui.ActiveDocument.setEdit(design().Name)
    widget("group").setCurrentText("Tiles")
    settle(200)
    fill(widget("HBody"), "45")
    until(lambda: design().Status == "invalid", 10, "the refusal")
    assert design().Verdict != "valid" and "HBody" in " ".join(design().Reasons), list(design().Reasons)
    picture("10-refused")
    close_panel()
    again_until("ctrl+z", lambda: design().HBody.Value == 2.8, "undo")
    assert design().Verdict == "valid", (design().Verdict, list(design().Reasons))


def export(folder):
    files = str(folder / "files")
    select(design())
    press("CurveUps_Export")
    fill(widget("folder"), files)
    picture("11-export")
    click(widget("write"))
    until(lambda: LIVE.busy or os.path.isdir(files), 20, "the export to begin")
    idle()
    names = sorted(os.listdir(files))
    assert any(name.endswith("-print.3mf") for name in names), names
    assert any(name.endswith("-print.step") for name in names) and "report.json" in names, names
    picture("12-exported")
    close_panel()


def save_close_reopen(folder):
    saved = str(folder / "whole-way.FCStd")
    verdict, tiles, name = design().Verdict, design().TileCount, design().Name
    in_dialog(lambda: keys("ctrl+s"), lambda: choose_file(saved))
    until(lambda: os.path.exists(saved), 20, "the file")
    FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
    until(lambda: not FreeCAD.listDocuments(), 20, "the document to close")
    in_dialog(lambda: keys("ctrl+o"), lambda: choose_file(saved))
    until(lambda: FreeCAD.ActiveDocument and FreeCAD.ActiveDocument.getObject(name), 30, "the document")
    settle(1000)
    assert (design().Verdict, design().TileCount, design().Status) == (verdict, tiles, "current")
    assert not design().Tiles.Visibility, "the solids hide the overlay"
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    assert picture("13-reopened") > 12


WAY = (open_a_mesh, new_design, place_a_cut, solve_live, change_thickness, verify, repair, refused_value,
       export, save_close_reopen)


@pytest.mark.freecad(timeout=600)
def test_the_whole_way(tmp_path):
    pictures = ROOT / "build" / "whole-way"
    shutil.rmtree(pictures, ignore_errors=True)
    keep_pictures_in(pictures)
    (tmp_path / "dome.obj").write_text(dome(5))
    Mesh.Mesh(str(tmp_path / "dome.obj")).write(str(tmp_path / "dome.stl"))
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    tidy()
    for step in WAY:
        try:
            step(tmp_path)
        except BaseException:
            picture("failed")
            raise
        assert "Traceback" not in report() and "unexpected" not in report(), report()[-2000:]
    assert len(list(pictures.glob("*.png"))) >= 13 and not (pictures / "failed.png").exists()
