# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands record as a macro does the same in a FreeCAD without a window."""

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
from robot import (at_rest, choose, click, entry_of, fill, in_dialog, menu_bar, picture, press, settle, until,
                   widget, write)
from steps import begin, click_edge, enter, leave, panel

pytestmark = pytest.mark.freecad(window=True, timeout=600)


def recording(start):
    """By the menu Macro; start: whether it starts or ends."""
    if not start:
        stop = entry_of("Std_MacroStopRecord", "Std_DlgMacroRecord")
        return choose(lambda: menu_bar("Macro"), stop)

    def begin_it():
        write("everything")
        click(widget("buttonStart"))

    in_dialog(lambda: choose(lambda: menu_bar("Macro"), entry_of("Std_DlgMacroRecord")), begin_it)


def state_of(document):
    """What a design has been made of."""
    design = document.Design
    return [list(map(str, design.Layout.Poses)), sorted(map(str, design.Cuts.Edges)), design.Verdict,
            {name: str(getattr(design, name)) for name in ("L", "HBody", "Tau", "TileCount")},
            design.Target.BuiltIn, round(design.Tiles.Shape.Volume, 6), design.Actuation]


def replayed(macro, folder):
    """What comes of it in a FreeCAD without a window."""
    script, out = folder / "replay.py", folder / "replayed.json"
    script.write_text("import json, runpy, FreeCAD\n" + inspect.getsource(state_of) + textwrap.dedent(f"""
        runpy.run_path({str(macro)!r}, run_name="__main__")
        open({str(out)!r}, "w").write(json.dumps(state_of(FreeCAD.ActiveDocument)))
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
    for group, name, value in (("Target", "L", "14"), ("Layout", "Tau", "2.9")):
        panel().turn_to(group)
        settle(300)
        enter(panel().form, name, value)
    until(lambda: (float(design.L), design.Tau) == (14, 2.9), 10, "values")
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
    design.Layout.Proxy = None
    press("CurveUps_RestoreObjects")
    recording(False)
    shutil.rmtree(tmp_path / "kit")
    files = sorted(os.listdir(tmp_path / "out"))
    assert files
    shutil.rmtree(tmp_path / "out")
    assert replayed(tmp_path / "everything.FCMacro", tmp_path) == state_of(document)
    assert sorted(os.listdir(tmp_path / "out")) == files
    assert (tmp_path / "kit" / "kit.json").exists()
    text = (tmp_path / "everything.FCMacro").read_text("utf-8")
    for name in ("newDocument", "new_design", "L = 14", "Tau = 2.9", "check", "divide", "set_cuts", "solve",
                 "verify", "repair", "actuate", "build_solids", "report", "export", "kit", "restore"):
        assert name in text, (name, text)
