# SPDX-License-Identifier: LGPL-2.1-or-later
"""States: a recompute compares everything with the keys of results, and names the reason; saving keeps
it. Nothing stays valid over old shapes."""

import shutil

import FreeCAD
import Mesh
import Part
import pytest
from curveups.base.errors import CurveUpsError
from curveups.features import actions, document as documents
from curveups.features.status import status_of
from curveups.stages.stage import Job

pytestmark = pytest.mark.freecad

PARTS = ("Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors")


def opened(path):
    document = FreeCAD.openDocument(str(path))
    return document, document.Design


def reopened(document, copy):
    document.saveAs(str(copy))
    FreeCAD.closeDocument(document.Name)
    return opened(copy)


def check_parts(design, *stale):
    """Assert that these parts alone are out of date, each with a reason."""
    states = {part: (getattr(design, part).Status, getattr(design, part).Reason) for part in PARTS}
    assert {part for part in PARTS if states[part][0] == "out of date"} == set(stale), states
    assert all(states[part][1] for part in stale)


def check_judged(design):
    assert (design.Verdict, design.Status, list(design.Reasons)) == ("valid", "current", [])
    assert design.Holds == "holds"
    check_parts(design)


def check_stale(design, name, command):
    assert (design.Verdict, design.Status) == ("out of date", "out of date"), (design.Verdict, name)
    assert design.Holds == "not settled"
    assert len(design.Reasons) == 1 and name in design.Reasons[0] and command in design.Reasons[0]


def refused(function, *arguments):
    with pytest.raises(CurveUpsError) as caught:
        function(*arguments)
    return str(caught.value)


@pytest.fixture
def document():
    return FreeCAD.newDocument("New")


def cap(radius=40):
    sphere = Part.makeSphere(radius, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 50, 90, 360)
    return next(face for face in sphere.Faces if "Sphere" in face.Surface.TypeId)


def solve(design, *goals):
    project = documents.project_of(design)
    documents.take(design, project.run(goals or ("design", "figures", "deviation", "verification")))
    design.Document.recompute()


SOLIDS = ("Tiles", "Support", "Anchors")


@pytest.mark.parametrize("name, value, command, parts", [
    ("HBody", "2.5 mm", "Verify", ("Verification", *SOLIDS)),
    ("FrictionCoefficient", 0.3, "Verify", ("Verification",)),
    ("ShearModulusBack", "0.3 MPa", "Verify", ("Verification",)),
    ("Tau", 2, "Solve", ("Layout", "Verification")),
    ("Flip", True, "Solve", ("Target", "Layout", "Verification")),
])
def test_an_edit_of_each_tier(dome_document, tmp_path, name, value, command, parts):
    """Commands know it at once; a recompute shows it, and has solids follow; through saving and back."""
    document, design = opened(dome_document)
    check_judged(design)
    before = getattr(design, name)
    setattr(design, name, value)
    states = status_of(design).parts
    assert {part for part, (state, _) in states.items() if state == "out of date"} == set(parts), states
    document.recompute()
    check_stale(design, name, command)
    check_parts(design, *set(parts).difference(SOLIDS))
    document, design = reopened(document, tmp_path / "copy.FCStd")
    check_stale(design, name, command)
    setattr(design, name, before)
    document.recompute()
    check_judged(design)


def test_what_concerns_settling_alone_leaves_valid_as_it_is(dome_document, tmp_path):
    document, design = opened(dome_document)
    assert design.SettledDeviation > 0 and design.LargestSlip >= 0
    for name, value in (("HoldTolerance", "0.5 mm"), ("MarginMismatch", 5)):
        before = getattr(design, name)
        setattr(design, name, value)
        document.recompute()
        assert (design.Verdict, design.Holds) == ("valid", "not settled"), name
        setattr(design, name, before)
        document.recompute()
        check_judged(design)
    design.HoldTolerance = "0.5 mm"
    document.recompute()
    document, design = reopened(document, tmp_path / "copy.FCStd")
    assert (design.Verdict, design.Holds) == ("valid", "not settled")
    actions.verify(design)
    assert (design.Verdict, design.Holds) == ("valid", "holds")
    # A margin that is required has a say in the verdict.
    design.Margin = "require"
    document.recompute()
    assert (design.Verdict, design.Holds) == ("out of date", "not settled")
    design.MarginMismatch, design.MarginFriction = 90, 0.01
    actions.verify(design)
    assert (design.Verdict, design.Holds) == ("not valid", "holds") and "margin" in design.Reasons[0]
    design.Margin = "report"
    document.recompute()
    assert design.Verdict == "out of date"


@pytest.mark.parametrize("name, value, reason", [
    ("HPin", "999 mm", "50.00 mm"), ("HBody", "45 mm", "back faces vanish"), ("PMin", "5 mm", "PMax"),
    ("HeldTiles", "'x'", "no tile")])
def test_a_refused_value_stays_and_is_said(capfd, dome_document, tmp_path, name, value, reason):
    """In one line with range or remedy, without a traceback; shapes and results stay as they were."""
    document, design = opened(dome_document)
    volume, results, before = document.Tiles.Shape.Volume, design.Results, getattr(design, name)
    setattr(design, name, value)
    typed = getattr(design, name)
    document.recompute()
    assert getattr(design, name) == typed
    assert (design.Verdict, design.Status) == ("not valid", "invalid"), (design.Verdict, design.Status)
    assert len(design.Reasons) == 1 and reason in design.Reasons[0], list(design.Reasons)
    assert document.Tiles.Shape.Volume == volume and design.Results == results
    if name == "PMin":  # of the layout: solids are of that which there is
        actions.build_solids(design)
    else:
        assert reason in refused(actions.build_solids, design)
    if name != "HBody":
        assert design.Label in refused(documents.settings_of, design)
    document, design = reopened(document, tmp_path / "copy.FCStd")
    assert (design.Verdict, design.Status) == ("not valid", "invalid"), (design.Verdict, design.Status)
    setattr(design, name, before)
    document.recompute()
    check_judged(design)
    assert abs(document.Tiles.Shape.Volume / volume - 1) < 1e-12
    out = "".join(capfd.readouterr())
    assert "Traceback" not in out, out
    assert sum(reason in line for line in out.splitlines()) == 1, out  # once in the report view


def test_the_source_is_an_object_of_the_document(document, tmp_path):
    copy = str(tmp_path / "copy.FCStd")
    source = document.addObject("Part::Feature", "Cap")
    source.Shape = cap()
    design = documents.new_design(document, source, "Dome")
    assert (design.Label, design.Verdict, design.Status) == ("Dome", "not judged", "empty")
    design.L = 14
    solve(design)
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)
    assert design.Target.Mesh.CountFacets == design.TileCount == len(design.Layout.Poses) // 6
    assert len(design.Verification.ContactNormalMin) == design.ContactCount
    assert abs(min(design.Verification.ContactNormalMin) - design.MinNormalForce) < 1e-9
    assert abs(design.Tiles.Shape.Volume / 1000 / design.TileVolume - 1) < 1e-6
    document.saveAs(copy)
    FreeCAD.closeDocument(document.Name)
    document = FreeCAD.openDocument(copy)
    design, source = document.Design, document.Cap
    assert design.Verdict == "valid" and documents.project_of(design).out_of_date("verification") == ()
    for change, back in ((lambda: setattr(source, "Shape", cap(41)), lambda: setattr(source, "Shape", cap())),
                         (lambda: setattr(source.Placement, "Base", FreeCAD.Vector(0, 0, 7)),
                          lambda: setattr(source.Placement, "Base", FreeCAD.Vector()))):
        change()
        document.recompute()
        assert design.Verdict == "out of date" and "Cap" in design.Reasons[0], list(design.Reasons)
        assert design.Target.Status == design.Layout.Status == "out of date"
        assert documents.project_of(design).out_of_date("layout") == ("source",)
        back()
        document.recompute()
        assert design.Verdict == "valid", list(design.Reasons)
    document.removeObject("Cap")
    document.recompute()
    assert design.Verdict == "out of date" and "deleted" in design.Reasons[0], list(design.Reasons)
    document.removeObject(design.Target.Name)
    document.recompute()
    assert design.Verdict == "out of date" and "target was deleted" in design.Reasons[0]
    documents.set_source(design, "cap")
    assert design.Target.BuiltIn == "cap" and design.Verdict == "out of date"
    solve(design, "design", "figures")
    assert (design.Verdict, design.Status, design.Verification.Status) == ("not judged", "current", "empty")


def test_a_mesh_or_a_file_as_source(document, dome_document, tmp_path):
    target = str(tmp_path / "dome.obj")
    shutil.copy(dome_document.parents[1] / "dome.obj", target)
    mesh = document.addObject("Mesh::Feature", "Surface")
    mesh.Mesh = Mesh.Mesh(target)
    mesh.Placement.Base = FreeCAD.Vector(0, 0, 3)
    for source in (mesh, target):
        design = documents.new_design(document, source)
        assert design.Label == ("Surface design" if source is mesh else "dome")
        design.Target.KeepMesh = True
        solve(design)
        assert design.TileCount == 54 and design.Verdict == "valid"
        assert abs(design.L.Value - 7.5) > 0.01  # the mesh's own
        assert documents.project_of(design).out_of_date("verification") == ()
        assert abs(max(v.z for v in design.Layout.Vertices) - (43 if source is mesh else 40)) < 1e-5
    with open(target, "a") as file:
        file.write("v 0 0 0" + chr(10))
    design.touch()
    document.recompute()
    assert design.Verdict == "out of date" and target in design.Reasons[0], list(design.Reasons)
    assert document.Design.Verdict == "valid"


def test_sources_that_are_none_change_nothing(document, tmp_path):
    (tmp_path / "text.txt").write_text("no target")
    folder = str(tmp_path)
    line = document.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0))
    for source, word in ((folder + "/nothing.stl", "no such"), (folder, "no file"), (line, "no surface"),
                         (folder + "/text.txt", "format")):
        assert word in refused(documents.new_design, document, source)
        assert [obj.Name for obj in document.Objects] == ["Line"]


def test_a_solve_is_one_step_of_undo(document):
    document.UndoMode = 1
    document.openTransaction("New")
    design = documents.new_design(document, "cap")
    design.L = 14
    document.commitTransaction()
    documents.project_of(design).run(("design", "figures", "verification"))
    states = []

    def state():
        return list(design.Layout.Poses), design.Results, list(design.Verification.ContactNormalMin)

    for tau in (3, 2.8):
        document.openTransaction("Solve")
        design.Tau = tau
        documents.take(design, documents.project_of(design).run(("design", "figures", "verification")))
        document.commitTransaction()
        assert design.Verdict == "valid" and design.Tau == tau
        states.append(state())
    assert states[0] != states[1]
    document.undo()
    assert (design.Verdict, design.Tau) == ("valid", 3), list(design.Reasons)
    assert state() == states[0]
    assert documents.project_of(design).out_of_date("verification") == ()
    document.undo()
    assert (design.Status, design.TileCount, list(design.Layout.Poses)) == ("empty", 0, [])
    document.redo()
    document.redo()
    assert state() == states[1]
    assert design.Verdict == "valid" and design.Target.Mesh.CountFacets == design.TileCount
    document.recompute()
    assert design.Tiles.Status == "current"
    document.undo()
    assert design.Tiles.Status == "out of date" and "layout" in design.Tiles.Reason
    for _ in range(2):
        document.undo()
    assert not documents.designs(document)
    document.redo()
    assert documents.designs(document)[0].Status == "empty"


def test_cuts(document):
    design = documents.new_design(document, "cap")
    design.L = 14
    assert "no tiles" in refused(documents.set_cuts, design, [[0, 1]])
    solve(design)
    F = documents.project_of(design).latest("target").F
    a, b = int(F[len(F) // 2][0]), int(F[len(F) // 2][1])
    documents.set_cuts(design, [[a, b]])
    assert design.Verdict == "out of date" and "cuts" in design.Reasons[0]
    assert design.Cuts.Status == design.Layout.Status == "out of date" != design.Target.Status
    documents.set_cuts(design, [])
    assert design.Verdict == "valid"
    documents.set_cuts(design, [[a, b]])
    refused(documents.set_cuts, design, [[0, 10**6]])
    assert list(design.Cuts.Edges) == [a, b]
    solve(design)
    assert design.CutCount == 1 and design.Cuts.Status == "current" and design.Verdict == "valid"


def test_a_sheet_that_sets_a_parameter_reads_figures_with_their_units(dome_document):
    document = FreeCAD.openDocument(str(dome_document))
    design, figures = document.Design, document.Verification
    assert figures.MinNormalForce.getValueAs("N").Value > 0 and figures.TileCount == design.TileCount
    for name, unit in (("MinNormalForce", "N"), ("FlatArea", "cm^2"), ("MaxDeviation", "mm"),
                       ("TileVolume", "cm^3")):
        value = getattr(figures, name).getValueAs(unit).Value
        assert abs(value - getattr(design, name)) <= 1e-9 * abs(value), (name, value)
    sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=Verification.MinNormalForce > 1 mN ? 2.5 mm : 3.5 mm")
    design.setExpression("HBody", "Sheet.A1")
    document.recompute()
    assert design.HBody.Value == 2.5 and "Invalid" not in (*design.State, *sheet.State)
    assert design.CreaseAngle.getValueAs("deg").Value == 180


def test_figures_do_not_outlive_their_layout(dome_document):
    """A run that is stopped makes a layout and measures little of it."""
    document, design = opened(dome_document)
    figures = ("MinNormalForce", "SettledDeviation", "MaxFriction")
    assert all(getattr(design, name) > 0 for name in figures)
    design.Tau = 2.8
    stop = Job(listen=lambda *_: setattr(stop, "stopped", True))
    results = documents.project_of(design).run(("design", "figures", "deviation", "verification"), stop)
    documents.take(design, results)
    assert results["layout"].stopped and design.TileCount == 54 and design.AreaRatio > 1
    assert not any(getattr(design, name) for name in figures)
    assert document.Verification.MinNormalForce.Value == 0


def test_figures_are_read_by_sheets_and_placement_moves_everything(dome_document):
    document, design = opened(dome_document)
    sheet = document.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "=Design.TileCount * 2")
    sheet.set("A2", "=Design.TileVolume / Design.AreaRatio")
    values = document.addObject("Spreadsheet::Sheet", "Values")
    values.set("A1", "=2 mm + 0.5 mm")
    design.setExpression("HBody", "Values.A1")
    document.recompute()
    assert sheet.A1 == 108 and abs(sheet.A2 - design.TileVolume / design.AreaRatio) < 1e-9
    check_stale(design, "HBody", "Verify")
    assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.5) < 1e-6 and document.Tiles.Status == "current"
    design.Placement.Base = FreeCAD.Vector(100, 0, 0)
    document.recompute()
    assert all(abs(document.getObject(part).Placement.Base.x - 100) < 1e-9
               for part in ("Target", "Tiles", "Support", "Anchors"))
    design.setExpression("HBody", None)
    design.HBody = 3
    document.recompute()
    check_judged(design)
    assert abs(document.Tiles.Shape.BoundBox.Center.x - 100) < 1


def test_copies_have_parts_of_their_own(dome_document, tmp_path):
    copy = str(tmp_path / "copy.FCStd")
    document, design = opened(dome_document)
    for deep in (True, False):
        document.copyObject(design, deep)
    designs = documents.designs(document)
    first, _, third = designs
    names = [getattr(design, part).Name for design in designs for part in PARTS]
    assert len(set(names)) == 21 and len(document.Objects) == 24, names
    third.HPin = 0.7
    document.recompute()
    assert [round(design.Tiles.Shape.BoundBox.ZLength, 6) for design in designs] == [5, 5, 4.4]
    assert [design.Verdict for design in designs] == ["valid", "valid", "out of date"]
    assert documents.design_of(third.Tiles) == third and documents.design_of(first.Cuts) == first
    document, design = reopened(document, copy)
    assert [design.Verdict for design in documents.designs(document)] == ["valid", "valid", "out of date"]


def test_running_is_said_and_ends(dome_document):
    document, design = opened(dome_document)
    documents.set_running(design, True)
    assert design.Status == "running"
    documents.set_running(design, False)
    check_judged(design)
