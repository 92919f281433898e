# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that macros record, in a FreeCAD without a window: from a surface to files."""

import json
import os

import FreeCAD
import pytest
from curveups.base.errors import CurveUpsError
from curveups.base.native import native
from curveups.features import actions, document as documents, properties
from curveups.features.design import warnings_of

pytestmark = pytest.mark.freecad


@pytest.fixture
def document():
    document = FreeCAD.newDocument("Made")
    document.UndoMode = 1
    return document


def refused(function, *arguments, **more):
    with pytest.raises(CurveUpsError) as caught:
        function(*arguments, **more)
    return str(caught.value)


def cap_in(document):
    sphere = document.addObject("Part::Sphere", "Sphere")
    sphere.Radius, sphere.Angle1 = 40, 35
    document.recompute()
    cap = document.addObject("Part::Feature", "Cap")
    cap.Shape = max(sphere.Shape.Faces, key=lambda face: face.Area)
    return cap


def test_a_window_does_not_wait_for_triangles_of_a_part(document, monkeypatch):
    """FreeCAD keeps Python's lock while it makes them: another process does."""
    import MeshPart

    monkeypatch.setattr(MeshPart, "meshFromShape", None)
    design = documents.new_design(document, cap_in(document))
    design.L = 11
    actions.divide(design)
    assert design.Target.Mesh.CountFacets > 20


def test_results_that_can_not_be_read_are_made_anew(document):
    design = documents.new_design(document, cap_in(document))
    design.L = 11
    actions.solve(design)
    design.Results = design.Results.replace('"version": 1', '"version": 0')
    assert warnings_of(design) == [] and "no layout" in refused(actions.verify, design)
    actions.solve(design)
    assert design.Verdict == "valid" and '"version": 1' in design.Results


def test_from_a_part_to_files(document, tmp_path):
    folder = str(tmp_path / "out")
    design = documents.new_design(document, cap_in(document), "My Cap")
    design.L = 11
    assert "no layout" in refused(actions.verify, design)
    results = actions.solve(design)
    assert design.Verdict == "valid", (design.Verdict, design.Reasons)
    assert design.TileCount == len(results.design.F) > 20
    assert document.UndoNames[0] == "Solve", document.UndoNames
    document.recompute()
    files = actions.export(design, folder, mask="{name}_{body}")
    expected = {f"My-Cap_{body}.{ending}" for body, ending in (
        ("tiles", "step"), ("support", "step"), ("anchors", "step"), ("print", "step"), ("actuated", "step"),
        ("tiles", "stl"), ("support", "stl"), ("anchors", "stl"), ("print", "3mf"))}
    expected |= {"design.json", "report.html", "report.json"}
    assert set(files) == expected == set(os.listdir(folder)), set(files) ^ expected
    page = actions.report(design, folder + "-report")
    assert "Valid" in open(page, encoding="utf-8").read()
    report = json.loads((tmp_path / "out" / "report.json").read_text("utf-8"))
    assert report["valid"] is True and report["name"] == "My-Cap" and report["contact_forces"]
    full = json.loads((tmp_path / "out-report" / "report.json").read_text("utf-8"))
    assert full["valid"] is True and full["deviation"]["mean_mm"] < 0.5 and full["layout"]["converged"]
    step = (tmp_path / "out" / "My-Cap_print.step").read_text("utf-8")
    assert "'T00001'" in step and "COLOUR_RGB" in step and "NOT VALID" not in step


def test_verify_and_repair_start_from_the_layout_as_it_stands(document):
    design = documents.new_design(document, "half-sphere")
    design.L = 12
    actions.solve(design)
    poses, verdict = list(design.Layout.Poses), design.Verdict
    assert verdict == "valid", design.Reasons
    # Contacts have to be held more firmly than the weakest is.
    design.FMinRatio = 1.2 * design.MinNormalForce / design.MeanNormalForce
    document.recompute()
    assert design.Verdict == "out of date", design.Verdict
    actions.verify(design)
    assert design.Verdict == "not valid" and list(design.Layout.Poses) == poses
    assert document.UndoNames[0] == "Verify"
    weak = design.MinNormalForce
    actions.repair(design)
    assert list(design.Layout.Poses) != poses and len(design.Layout.Poses) == len(poses)
    assert design.MinNormalForce > weak, (design.MinNormalForce, weak)
    document.undo()
    assert list(design.Layout.Poses) == poses and design.Verdict == "not valid"


def test_what_should_not_be_printed_is_refused_or_says_so(document, tmp_path):
    folder = str(tmp_path / "out")
    design = documents.new_design(document, "half-sphere")
    design.L = 12
    actions.solve(design)
    design.Tau = 2.5
    document.recompute()
    text = refused(actions.export, design, folder)
    assert "out of date" in text and "Tau" in text and "insist" in text, text
    assert not os.path.exists(folder)
    actions.export(design, folder, insist=True, files=(("print", "step"), ("tiles", "stl"), ("print", "3mf")))
    out = tmp_path / "out"
    report = json.loads((out / "report.json").read_text("utf-8"))
    assert report["valid"] is False and "Tau" in report["reasons"][0]
    assert "Not valid" in (out / "report.html").read_text(encoding="utf-8")
    step = (out / "half-sphere-print.step").read_text("utf-8")
    assert "PRODUCT('NOT VALID half-sphere" in step and "'T00001'" in step and "COLOUR_RGB" in step
    assert b"NOT VALID" in (out / "half-sphere-tiles.stl").read_bytes()[:80]


def test_exports_that_can_not_be(document, tmp_path):
    folder = str(tmp_path / "out")
    design = documents.new_design(document, "half-sphere")
    assert "no layout" in refused(actions.export, design, folder)
    design.L = 12
    actions.solve(design)
    for mask, words in (("{nam}", "nam"), ("{name", "{name}"), ("x", "{body}"), ("a/b-{body}", "for a file")):
        text = refused(actions.export, design, folder, mask=mask)
        assert words in text, text
    assert "mesh_deviation" in refused(actions.export, design, folder, deviation=99.0)
    assert not os.path.exists(folder)


def test_a_target_is_checked_and_sizes_that_do_are_taken(document):
    design = documents.new_design(document, "mask")
    design.L, design.HBody = 14, 28
    results = actions.find_sizes(design)
    assert document.UndoNames[0] == "Find Sizes" and design.Verdict == "not judged", design.Verdict
    assert results["feasibility"].blocked and not results["feasibility"].feasible
    best = results["sizes"].H_body
    assert 1 < best < 28, best
    assert design.Target.Mesh.CountFacets == len(results["feasibility"].F)
    design.HBody = best
    assert actions.check(design)["feasibility"].feasible and document.UndoNames[0] == "Check"

    chosen = actions.choose_sizes(design, ("H_body",)).values
    assert document.UndoNames[0] == "Choose Sizes" and set(chosen) == {"H_body"}
    assert 0 < float(design.HBody) == chosen["H_body"] <= 3 / 7 * 14, chosen
    design.setExpression("L", "5 mm + 6 mm")
    said = refused(actions.choose_sizes, design)
    assert "L follows an expression" in said, said
    design.setExpression("L", None)
    design.MaximumDeviation = 0.6
    chosen = actions.choose_sizes(design).values
    assert (float(design.L), float(design.HBody)) == (chosen["L"], chosen["H_body"])


def test_a_profile_sets_what_suits_a_printer_and_nothing_else(document):
    design = documents.new_design(document, "half-sphere")
    design.Tau = 4
    before = {name: getattr(design, name) for name in design.PropertiesList}
    actions.apply_profile(design, "fdm")
    assert document.UndoNames[0] == "Apply Profile"
    assert (design.L.Value, design.Printer, design.Bumps, design.Tau) == (10, "fdm", "none", 4), design.L
    actions.apply_profile(design, "")
    changed = [name for name, value in before.items()
               if name not in ("Reasons",) and str(getattr(design, name)) != str(value)]
    assert changed == [], changed


def test_a_material_is_chosen_by_name(document):
    design = documents.new_design(document, "half-sphere")
    actions.apply_material(design, "material_tile", "petg")
    assert document.UndoNames[0] == "Apply Material" and properties.value_of(design, "Density") == 1.27
    design.setExpression("ThicknessFront", "0.4 mm")
    count = len(document.UndoNames)
    for kind, name, wrong in (("material_membrane", "latex-0.25", "ThicknessFront follows an expression"),
                              ("material_glue", "latex-0.25", "there is no material_glue 'latex-0.25'")):
        with pytest.raises(CurveUpsError, match=wrong):
            actions.apply_material(design, kind, name)
    assert design.ThicknessBack.Value == 0.5 and len(document.UndoNames) == count


def test_density_follows_the_printer_until_it_is_set(document):
    design = documents.new_design(document, "half-sphere")

    def density():
        return round(properties.value_of(design, "Density"), 6)

    assert density() == 1.18
    with actions.transaction(document, "Printer"):
        design.Printer = "fdm"
    assert density() == 1.24
    document.undo()
    assert (design.Printer, density()) == ("polyjet", 1.18)
    document.redo()
    assert (design.Printer, density()) == ("fdm", 1.24)
    properties.write_parameter(design, "density", 1.05)
    design.Printer = "polyjet"
    assert density() == 1.05
    # What is written together stays as it is given.
    given = native.Parameters()
    given.set("printer", "fdm")
    properties.write_parameters(design, given)
    assert (design.Printer, density()) == ("fdm", 1.18)


def test_a_step_of_undo_is_in_its_own_document_alone(document):
    design = documents.new_design(document, "half-sphere")
    other = FreeCAD.newDocument("Other")  # which a user looks at when a run ends
    other.UndoMode = 1
    actions.apply_profile(design, "fdm")
    assert document.UndoNames[0] == "Apply Profile" and other.UndoNames == []
    assert FreeCAD.ActiveDocument == other


def test_a_kit_goes_out_of_date_with_its_design(dome_document, tmp_path):
    design = FreeCAD.openDocument(str(dome_document)).Design
    assert design.Kit == "" and "Hidden" in design.getEditorMode("Kit")
    folder = tmp_path / "kit"
    page = actions.kit(design, str(folder))
    assert design.Kit == "current" and os.path.getsize(page) > 50000
    shop, = folder.glob("*-shop.pdf")
    shop.unlink()
    assert actions.kit(design, str(folder)) == page
    assert shop.exists()
    before = design.AnchorRadius.Value
    design.AnchorRadius = before + 1
    document = design.Document
    document.recompute()
    assert design.Kit.startswith("out of date: ") and "AnchorRadius" in design.Kit
    design.AnchorRadius = before
    document.recompute()
    assert design.Kit == "current"
    design.MeshDeviation = 2 * design.MeshDeviation.Value  # of files alone
    document.recompute()
    assert design.Kit.startswith("out of date: ")
    actions.kit(design, str(folder))
    assert design.Kit == "current"
    design.Document.saveAs(str(tmp_path / "saved.FCStd"))
    FreeCAD.closeDocument(design.Document.Name)
    assert FreeCAD.openDocument(str(tmp_path / "saved.FCStd")).Design.Kit == "current"
