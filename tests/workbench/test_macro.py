# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macros that commands record do the same in a FreeCAD without a window."""

import inspect
import json
import os
import shutil
import subprocess
import textwrap

import FreeCAD
import FreeCADGui
import pytest
from curveups.features import document as designs
from curveups.window import qt
from freecad_process import command as started
from robot import (at_rest, choose, choose_file, click, entry_of, fill, in_dialog, keys, menu_bar, picture,
                   press, settle, until, widget, write)
from running import dome
from steps import begin, click_edge, enter, leave, panel

pytestmark = [pytest.mark.freecad(window=True, timeout=600), pytest.mark.all]


def recording(start):
    """Start or end a recording by the menu Macro."""
    if not start:
        stop = entry_of("Std_MacroStopRecord", "Std_DlgMacroRecord")
        return choose(lambda: menu_bar("Macro"), stop)

    def begin_it():
        write("everything")
        click(widget("buttonStart"))

    in_dialog(lambda: choose(lambda: menu_bar("Macro"), entry_of("Std_DlgMacroRecord")), begin_it)


def state_of(document):
    """Figures of a design that its macro has to make again."""
    design = document.Design
    return [list(map(str, design.Layout.Poses)), sorted(map(str, design.Cuts.Edges)), design.Verdict,
            {name: str(getattr(design, name)) for name in ("L", "HBody", "Tau", "TileCount")},
            design.Target.BuiltIn, round(design.Tiles.Shape.Volume, 6), design.Actuation]


def designs_in(document):
    """Figures of designs of own surfaces. A shape that was saved has other last digits."""
    designs = [obj for obj in document.Objects if "CurveUpsVersion" in obj.PropertiesList]
    names = "L", "HBody", "HPin", "Gravity", "HeldTiles", "Faces", "TileCount"
    return [[design.Name, design.Target.File, design.Target.Source and design.Target.Source.Name,
             [round(number, 6) for number in design.Layout.Poses],
             {name: str(getattr(design, name)) for name in names}] for design in designs]


def replayed(macro, folder, state=state_of, beginning=None):
    """State after a macro in a FreeCAD without a window. beginning: the document that was open before."""
    script, out = folder / "replay.py", folder / "replayed.json"
    script.write_text("import json, runpy, FreeCAD\n" + inspect.getsource(state) + textwrap.dedent(f"""
        if {beginning and str(beginning)!r}:
            FreeCAD.openDocument({beginning and str(beginning)!r})
        runpy.run_path({str(macro)!r}, run_name="__main__")
        open({str(out)!r}, "w").write(json.dumps({state.__name__}(FreeCAD.ActiveDocument)))
        """))
    done = subprocess.run(started(script, window=False), capture_output=True, text=True)
    assert out.exists(), done.stdout + done.stderr
    return json.loads(out.read_text("utf-8"))


def test_a_macro_of_all_commands_replays_without_a_window(monkeypatch, tmp_path, pictures):
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: None)
    begin()
    FreeCAD.closeDocument("Made")
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", str(tmp_path))
    recording(True)
    choose(lambda: menu_bar("CurveUps"), "Examples", "Disc")
    leave()
    document = FreeCAD.ActiveDocument
    document.UndoMode = 1
    design = document.Design
    design.ViewObject.doubleClicked()
    until(lambda: panel() is not None and panel().form.isVisible(), 10, "the panel")
    settle(500)
    for group, name, value in (("Target", "L", "20"), ("Layout", "Tau", "2.9")):
        panel().turn_to(group)
        settle(300)
        enter(panel().form, name, value)
    until(lambda: (float(design.L), design.Tau) == (20, 2.9), 10, "values")
    leave()
    for name in ("Cuts", "Check", "Solve"):
        press(f"CurveUps_{name}")
        leave()
    press("CurveUps_Cuts")
    at_rest()
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    settle(500)
    picture("before-the-cut")
    click_edge(design, 20, 10)
    leave()
    assert len(designs.cuts_of(design))
    for name in ("Solve", "Verify", "Repair", "Actuate", "BuildSolids", "ShowFlat", "ShowActuated",
                 "ShowSolids", "Overlay", "WorstContacts", "Report"):
        press(f"CurveUps_{name}")
        leave()
    press("CurveUps_Export")
    fill(panel().form.folder, str(tmp_path / "out"))
    click(panel().form.write)
    leave()
    press("CurveUps_Kit")
    fill(panel().form.folder, str(tmp_path / "kit"))
    click(panel().form.write)
    leave()
    recording(False)
    shutil.rmtree(tmp_path / "kit")
    files = sorted(os.listdir(tmp_path / "out"))
    assert files
    shutil.rmtree(tmp_path / "out")
    assert replayed(tmp_path / "everything.FCMacro", tmp_path) == state_of(document)
    assert sorted(os.listdir(tmp_path / "out")) == files
    assert (tmp_path / "kit" / "kit.json").exists()
    text = (tmp_path / "everything.FCMacro").read_text("utf-8")
    for name in ("newDocument", "new_design", "L = 20", "Tau = 2.9", "check", "divide", "set_cuts", "solve",
                 "verify", "repair", "actuate", "build_solids", "report", "export", "kit"):
        assert name in text, (name, text)


def test_a_macro_of_ones_own_surfaces_replays_without_a_window(tmp_path, pictures):
    """New Design of faces and of a file, Change Target, sizes that Check offers, and held tiles."""
    import Part

    made = begin()
    cap = made.addObject("Part::Feature", "Cap")
    cap.Shape = Part.makeSphere(40, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 35)
    other = made.addObject("Part::Feature", "Other")
    other.Shape = max(Part.makeSphere(44, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 40).Faces,
                      key=lambda face: face.Area)
    made.recompute()
    made.saveAs(str(tmp_path / "Made.FCStd"))
    (tmp_path / "dome.obj").write_text(dome(2))
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Macro").SetString("MacroPath", str(tmp_path))
    recording(True)
    FreeCADGui.Selection.addSelection(cap, "Face1")
    press("CurveUps_NewDesign")
    until(lambda: made.getObject("Design"), 10, "the design")
    design = made.Design
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(other)
    press("CurveUps_Target")
    until(lambda: design.Target.Source is other, 10, "the other target")
    design.ViewObject.doubleClicked()
    until(lambda: panel() is not None and panel().form.isVisible(), 10, "the panel")
    settle(500)
    for group, name, value in (("Target", "L", "12"), ("Tiles", "HBody", "40")):
        panel().turn_to(group)
        settle(300)
        enter(panel().form, name, value)
    until(lambda: (float(design.L), float(design.HBody)) == (12, 40), 10, "values")
    leave()
    press("CurveUps_Check")
    form = widget("CheckPanel")
    at_rest()
    picture("check")
    click(form.find)
    at_rest()
    assert "HBody" in form.use_thickness.text() and form.use_thickness.isVisible(), form.verdict.text()
    click(form.use_thickness)
    at_rest()
    assert float(design.HBody) < 40
    before = float(design.L), float(design.HBody)
    click(form.choose)
    at_rest()
    assert (float(design.L), float(design.HBody)) != before
    leave()
    press("CurveUps_Solve")
    leave()
    assert design.TileCount > 4
    design.ViewObject.doubleClicked()
    until(lambda: panel() is not None and panel().form.isVisible(), 10, "the panel again")
    panel().turn_to("Physics")
    settle(300)
    if not panel().form.all.isChecked():
        click(panel().form.all)
        settle(300)
    box = widget("Gravity")
    click(box)
    write("held")
    keys("Return")
    until(lambda: design.Gravity == "held", 10, "held tiles")
    fill(widget("HeldTiles"), "T00003")
    until(lambda: design.HeldTiles == "T00003", 10, "a held tile")
    leave()
    FreeCADGui.Selection.clearSelection()
    in_dialog(lambda: press("CurveUps_NewDesign"), lambda: choose_file(str(tmp_path / "dome.obj")))
    until(lambda: made.getObject("Design001"), 10, "a design of a file")
    leave()
    recording(False)
    found = replayed(tmp_path / "everything.FCMacro", tmp_path, designs_in, tmp_path / "Made.FCStd")
    assert found == designs_in(made) and len(found) == 2
    assert found[0][2] == "Other" and found[1][1].endswith("dome.obj"), found
