# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands and panels in a real window: their traces in the document, the report view, the picture."""

import json
import os

import FreeCAD
import FreeCADGui
import Mesh
import Part
import pytest
from curveups.base.errors import CurveUpsError
from curveups.base.findings import Finding
from curveups.project.worker import WORKER
from curveups.window import new_design, qt
from curveups.window.new_design import make_design
from curveups.window.notice import show_error
from curveups.window.overlays import overlay_of
from robot import action, at_rest, click, picture, press, QtCore, QtGui, report, settle, tidy, until, widget
from steps import begin, enter, example, LIVE, panel

pytestmark = pytest.mark.freecad(window=True)


def test_an_example_is_solved_while_one_watches(pictures):
    begin()
    FreeCADGui.runCommand("CurveUps_Example_half-sphere")
    made = FreeCAD.ActiveDocument
    assert made.Label == "Half-Sphere" and LIVE.busy, (made.Label, report(), panel())
    design = made.Design
    until(lambda: panel().form.isVisible(), 5, "the panel")
    assert design.Status == "running"
    assert not FreeCADGui.Command.get("CurveUps_Solve").isActive()
    assert "at work" in FreeCADGui.Command.get("CurveUps_Solve").getAction()[0].statusTip()
    overlay = overlay_of(design)
    until(lambda: overlay._iterating, 60, "a picture of the layout while it is solved")
    colours = picture("solving")
    assert colours > 20, colours
    at_rest()
    assert design.Verdict == "valid", (design.Verdict, design.Reasons)
    assert picture("solved") > 20 and not overlay._iterating
    stages = panel().form.stages
    shown = [stages.topLevelItem(row).text(0) for row in range(stages.topLevelItemCount())]
    assert any("Layout" in text for text in shown), shown
    assert all(text.startswith("\u2713") for text in shown), shown
    assert made.UndoNames[0] == "Solve", made.UndoNames
    assert "valid, holds" in panel().form.verdict.text() and design.Holds == "holds"
    # Nothing moves at rest: FreeCAD would compose its window anew for each picture.
    assert not panel().form.progress.findChildren(QtCore.QAbstractAnimation)
    made.undo()
    settle(300)
    assert design.Verdict == "not judged" and not list(design.Layout.Poses)
    made.redo()
    settle(300)
    assert design.Verdict == "valid" and list(design.Layout.Poses)
    panel().reject()
    settle(300)
    assert panel() is None and not FreeCADGui.Control.activeDialog()
    press("CurveUps_SolverStatus")
    text = widget("CurveUpsSolverStatus").text()
    assert "ready" in text and "cpython" in text, text
    widget("CurveUpsSolverStatus").close()


def test_cancel_stop_and_closing_in_mid_run(pictures):
    def solving(design, iterates=2):
        FreeCADGui.runCommand("CurveUps_Solve")
        assert LIVE.busy
        until(lambda: WORKER.status().count >= iterates, 60, "the layout to begin")

    made, design = example("tower", L=10)
    before = design.Results
    solving(design)
    click(panel().form.cancel)
    until(lambda: not LIVE.busy, 5)
    assert design.Results == before and design.Verdict == "not judged" and design.TileCount == 0
    assert "cancelled" in panel().form.line.text(), panel().form.line.text()
    assert WORKER.wait(20)

    solving(design, 3)
    click(panel().form.stop)
    at_rest()
    assert len(design.Layout.Poses) == 6 * design.TileCount > 0
    assert design.Verdict != "valid", design.Verdict
    picture("stopped")
    kept = list(design.Layout.Poses)

    # What was stopped is begun anew; the panel is closed meanwhile, and nothing is lost.
    design.L = 13
    made.recompute()
    panel().run("solve")
    panel().reject()
    settle(200)
    assert LIVE.busy and panel() is None
    at_rest()
    assert list(design.Layout.Poses) != kept
    assert design.Status != "running"

    # The document goes away while something is solved in it: FreeCAD lives on.
    solving(design, 0)
    FreeCAD.closeDocument(made.Name)
    settle(500)
    assert not LIVE.busy and panel() is None and not FreeCADGui.Control.activeDialog()
    again = FreeCAD.newDocument("Again")
    design = make_design(again, repr("half-sphere"))
    design.L = 14
    again.recompute()
    FreeCADGui.runCommand("CurveUps_Solve")
    # The design is deleted while it is solved.
    settle(100)
    again.removeObject(design.Name)
    settle(300)
    assert not LIVE.busy
    assert WORKER.wait(20)
    assert "Traceback" not in report() and "unexpected" not in report(), report()


def test_designs_of_selected_surfaces_and_their_targets(tmp_path, monkeypatch, pictures):
    broken = str(tmp_path / "broken.stl")

    def select(obj):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(obj)
        settle(100)

    made = begin()
    sphere = made.addObject("Part::Feature", "Cap")
    sphere.Shape = max(Part.makeSphere(40, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 35).Faces,
                       key=lambda face: face.Area)
    mesh = made.addObject("Mesh::Feature", "Facets")
    mesh.Mesh = Mesh.Mesh(sphere.Shape.tessellate(0.3))
    made.addObject("App::FeaturePython", "Nothing")
    made.recompute()
    assert not FreeCADGui.Command.get("CurveUps_Solve").isActive()
    assert "no design" in action("CurveUps_Solve").statusTip()
    select(sphere)
    press("CurveUps_NewDesign")
    assert made.Design.Target.Source == sphere and made.Design.Label.startswith("Cap")
    assert made.UndoNames[0] == "New Design"
    select(mesh)
    press("CurveUps_NewDesign")
    second = [obj for obj in made.Objects if obj.Name.startswith("Design")][-1]
    assert second.Target.Source == mesh
    FreeCADGui.Selection.addSelection(sphere)
    FreeCADGui.Selection.addSelection(mesh)
    count = len(made.Objects)
    press("CurveUps_NewDesign")
    until(lambda: "2 surfaces are selected" in report(), 10, "the error")
    assert len(made.Objects) == count
    FreeCADGui.Selection.clearSelection()
    settle(500)
    assert not FreeCADGui.Command.get("CurveUps_Solve").isActive()
    assert "several" in action("CurveUps_Solve").statusTip()
    made.undo()
    settle(200)
    assert len([obj for obj in made.Objects if obj.Name.startswith("Design")]) == 1
    design = made.Design
    design.L = 11
    made.recompute()
    FreeCADGui.Selection.addSelection(design)
    press("CurveUps_Solve")
    at_rest()
    assert design.TileCount > 20 and design.State != ["Invalid"], design.Verdict
    panel().reject()
    settle(200)
    # Another target: the layout is out of date, and undo brings it back.
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(mesh)
    press("CurveUps_Target")
    settle(200)
    assert design.Target.Source == mesh and design.Status == "out of date", design.Reasons
    made.undo()
    settle(200)
    assert design.Target.Source == sphere and design.Status != "out of date", design.Reasons
    # A file, by its dialog; one that is none is refused in one line, and nothing is left of it.
    FreeCADGui.Selection.clearSelection()
    count = len(made.Objects)
    with open(broken, "w") as file:
        file.write("nothing")
    monkeypatch.setattr(new_design, "ask_for_file", lambda title: broken)
    FreeCADGui.runCommand("CurveUps_NewDesign")
    settle(300)
    names = len(made.Objects)
    if names > count:  # its content is only read when it is solved
        FreeCADGui.runCommand("CurveUps_Solve")
        at_rest()
        assert panel().form.line.text(), "no line"
        picture("broken")
    assert "Traceback" not in report(), report()


def test_verify_repair_solids_report_and_export(tmp_path, monkeypatch, pictures):
    out = str(tmp_path / "print")
    saved = str(tmp_path / "saved.FCStd")
    made, design = example(L=14)
    FreeCADGui.runCommand("CurveUps_Solve")
    at_rest()
    assert design.Verdict == "valid", design.Reasons
    form = panel().form
    # Softer membranes: the verdict waits for Verify.
    form.group.setCurrentIndex(form.group.findText("Physics"))
    settle(200)
    enter(form, "FrictionCoefficient", "0.4")
    until(lambda: abs(design.FrictionCoefficient - 0.4) < 1e-9, 5, "the edit to arrive")
    assert design.Verdict == "out of date" and made.UndoNames[0] == "Edit the design", made.UndoNames
    until(lambda: "out of date, not settled" in form.verdict.text(), 5, "the verdict")
    click(form.verify)
    at_rest()
    picture("verified")
    assert "valid, holds" in form.verdict.text()
    assert design.Verdict == "valid" and made.UndoNames[0] == "Verify", design.Reasons
    click(form.repair)
    at_rest()
    assert design.Verdict == "valid" and design.TileCount
    # Thickness: solids follow by themselves once there is peace, or at once by the command.
    form.group.setCurrentIndex(form.group.findText("Tiles"))
    settle(200)
    enter(form, "HBody", "2.5 mm")
    until(lambda: abs(design.HBody.Value - 2.5) < 1e-9, 5)
    panel().reject()
    settle(100)
    FreeCADGui.runCommand("CurveUps_BuildSolids")
    at_rest()
    until(lambda: abs(design.Tiles.Shape.BoundBox.ZLength - 4.5) < 1e-6, 60, "solids of the new thickness")
    assert design.Tiles.Status == "current"
    assert design.Verdict == "out of date", design.Verdict
    panel().reject()
    settle(100)

    press("CurveUps_Export")
    form = panel().form
    picture("export-refused")
    assert not form.write.isEnabled() and "HBody" in form.doubts.text()
    assert "Tick 'Write them anyway'" in form.write.toolTip()
    form.folder.setText(out)
    form.names.setText("{nam}")
    form.insist.setChecked(True)
    form.write.click()
    assert "nam" in form.line.text() and not os.path.exists(out), form.line.text()
    form.names.setText("{name}-{body}")
    assert "half-sphere-print.3mf" in form.chosen.text(), form.chosen.text()
    form.write.click()
    at_rest()
    picture("exported")
    assert "files in" in form.line.text(), form.line.text()
    assert os.path.exists(os.path.join(out, "half-sphere-print.step"))
    FreeCADGui.Control.closeDialog()
    settle(100)

    pages = []
    monkeypatch.setattr(qt.QtGui.QDesktopServices, "openUrl", lambda url: pages.append(url.toLocalFile()))
    made.saveAs(saved)
    press("CurveUps_Report")
    at_rest()
    assert pages and pages[0].startswith(os.path.dirname(saved)) and os.path.getsize(pages[0]) > 50000, pages
    assert "Traceback" not in report() and "unexpected" not in report(), report()
    written = json.loads((tmp_path / "print" / "report.json").read_text(encoding="utf-8"))
    assert written["valid"] is False and "HBody" in written["reasons"][0], written["reasons"]
    assert "NOT VALID" in (tmp_path / "print" / "half-sphere-print.step").read_text(encoding="utf-8")[:3000]


def test_errors_are_one_line_with_tiles_to_click(pictures):
    made, design = example(L=14)
    FreeCADGui.runCommand("CurveUps_Solve")
    at_rest()
    panel().reject()
    settle(200)
    finding = Finding.about("sharp_fold", (11, 43), count=2, H_body=3.0)
    show_error(CurveUpsError(str(finding), "Design, T00012, T00044", "make HBody less", finding=finding),
               "Solve")
    settle(700)
    notice = widget("CurveUpsNotice")
    assert 'href="T00012"' in notice.text()
    picture("notice")
    notice.findChild(QtGui.QLabel, "qt_msgbox_label").linkActivated.emit("T00012")
    selected = FreeCADGui.Selection.getSelectionEx()
    assert [selection.SubElementNames for selection in selected] == [("T00012",)], selected
    lines = [line for line in report().splitlines() if "back faces" in line]
    assert len(lines) == 1 and "make HBody less" in lines[0]
    click(notice.findChild(QtGui.QPushButton))
    settle(200)
    shown = [w.objectName() for w in QtGui.QApplication.allWidgets() if w.isVisible()]
    assert "CurveUpsNotice" not in shown
    # A value that can't be is said with the range, in the panel; the run is refused.
    design.HBody = 200
    made.recompute()
    FreeCADGui.runCommand("CurveUps_Solve")
    settle(300)
    assert not LIVE.busy
    text = panel().form.line.text()
    assert "HBody" in text and "100" in text, text
    assert "Traceback" not in report(), report()


@pytest.mark.freecad(home="no native")
def test_without_the_native_module(pictures):
    """The workbench opens, says what is wrong and how to mend it, and refuses what can't be."""
    FreeCADGui.activateWorkbench("CurveUpsWorkbench")
    settle(500)
    tidy()
    for name in ("NewDesign", "Solve", "Export"):
        assert not FreeCADGui.Command.get("CurveUps_" + name).isActive(), name
    tip = action("CurveUps_NewDesign").statusTip()
    assert "has not been built" in tip, tip
    press("CurveUps_SolverStatus")
    text = widget("CurveUpsSolverStatus").text()
    picture("status")
    assert "has not been built" in text and "tools/setup" in text and "cpython" in text, text
