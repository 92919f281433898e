# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents stay whole wherever they were saved: without the workbench, without its native module, by
the first version."""

import sys
from pathlib import Path

import FreeCAD
import pytest
from curveups.base.native import problem
from curveups.features import document as documents

pytestmark = pytest.mark.freecad

OLD = Path(__file__).parent / "data" / "first-version.FCStd"
RELEASED = Path(__file__).parent / "data" / "version-0.1.0.FCStd"
PARTS = ("Target", "Cuts", "Layout", "Verification", "Tiles", "Support", "Anchors")


def opened(path):
    document = FreeCAD.openDocument(str(path))
    return document, document.Design


def check_whole(path):
    document, design = opened(path)
    assert type(design.Proxy).__name__ == "DesignProxy"
    assert type(document.Tiles.Proxy).__name__ == "BodiesProxy"
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)
    assert [getattr(design, part).Status for part in PARTS] == ["current"] * 7
    setattr(design, "HPin", "0.8 mm")
    assert design.Verdict == "out of date"
    document.recompute()
    assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.6) < 1e-6 and document.Tiles.Status == "current"
    documents.take(design, documents.design_project_of(design).run(("figures", "verification")))
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)


def save_twice(path, copy, again):
    """Without the workbench."""
    document, design = opened(path)
    assert not any("CurveUps" in folder for folder in sys.path)
    assert len(document.Tiles.Shape.Solids) == 54
    document.recompute()
    document.saveAs(str(copy))
    FreeCAD.closeDocument(document.Name)
    FreeCAD.openDocument(str(copy)).saveAs(str(again))


def edit(path, copy):
    """Without the workbench."""
    document, design = opened(path)
    design.HBody = "2.5 mm"
    document.recompute()
    document.saveAs(str(copy))


def test_saved_without_the_workbench(dome_document, elsewhere, tmp_path):
    elsewhere(save_twice, dome_document, tmp_path / "foreign.FCStd", tmp_path / "again.FCStd", home="nothing")
    check_whole(tmp_path / "again.FCStd")


def test_edited_without_the_workbench(dome_document, elsewhere, tmp_path):
    elsewhere(edit, dome_document, tmp_path / "edited.FCStd", home="nothing")
    document, design = opened(tmp_path / "edited.FCStd")
    assert design.Verdict == "out of date" and "HBody" in design.Reasons[0], list(design.Reasons)
    assert document.Tiles.Status == "out of date" and document.Layout.Status == "current"
    document.recompute()
    assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.5) < 1e-6


def open_and_edit(path, same, edited):
    """Without the native module: an edit is noticed, by comparison alone."""
    document, design = opened(path)
    assert "run tools/setup" in str(problem())
    assert type(design.Proxy).__name__ == "DesignProxy"
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)
    document.recompute()
    document.saveAs(str(same))
    for name, value, part in (("HBody", "2.5 mm", "Tiles"), ("Tau", 2.5, "Layout"),
                              ("FrictionCoefficient", 0.4, "Verification")):
        kept = getattr(design, name)
        setattr(design, name, value)
        assert (design.Verdict, design.Status) == ("out of date", "out of date"), name
        assert name in design.Reasons[0] and getattr(design, part).Status == "out of date", name
        setattr(design, name, kept)
        assert design.Verdict == "valid", (name, list(design.Reasons))
    design.setExpression("Tau", "1.5 + 1")
    document.recompute()
    assert design.Verdict == "out of date" and len(document.Tiles.Shape.Solids) == 54
    document.saveAs(str(edited))


@pytest.mark.parametrize("home", ["no native", "broken native"])
def test_without_the_native_module(dome_document, elsewhere, tmp_path, home):
    """It opens and shows; an edit is noticed, by comparison alone; what was saved is whole."""
    same, edited = tmp_path / "same.FCStd", tmp_path / "edited.FCStd"
    said = elsewhere(open_and_edit, dome_document, same, edited, home=home)[1]
    assert "Traceback" not in said, said
    check_whole(same)
    document, design = opened(edited)
    assert design.Verdict == "out of date" and design.Tau == 2.5, (design.Verdict, design.Tau)
    design.setExpression("Tau", None)
    design.Tau = 3
    assert design.Verdict == "valid", list(design.Reasons)


def test_a_document_of_the_first_version(capfd, tmp_path):
    """Its parameters, expressions on them and expressions that read them, its verdict, its shapes."""
    copy = str(tmp_path / "migrated.FCStd")
    document, design = opened(OLD)
    figures, values, tiles = document.Figures, document.Values, document.Tiles
    assert (design.TileCount, len(tiles.Shape.Solids)) == (24, 24)
    assert [getattr(design, part).Name for part in PARTS] == list(PARTS)
    assert design.SupportKind == "none" and not design.WithAnchors and design.Bumps == "none"
    assert not {"H_body", "tau", "SolvedVerdict", "d_gap_min"} & set(design.PropertiesList)
    # Two values were changed since it was judged: no verdict is taken over for them.
    assert design.Verdict == "out of date" and "HPin" in design.Reasons[0], list(design.Reasons)
    assert tiles.Status == "current" and abs(tiles.Shape.BoundBox.ZLength - 4.8) < 1e-6
    assert figures.getContents("A1") == "=Design.HBody * 2" and figures.getContents("D1").endswith("text")
    assert sorted(design.ExpressionEngine) == [("BumpHeight", "HPin / 4"), ("HPin", "Values.B2")]
    document.recompute()
    assert figures.A1.Value == 6 and abs(figures.C3.Value - 1.6) < 1e-9 and document.Box.Length.Value == 8
    values.set("B2", "=1 mm")
    document.recompute()
    assert (design.HPin.Value, design.BumpHeight.Value, design.Verdict) == (1, 0.25, "valid")
    assert abs(tiles.Shape.BoundBox.ZLength - 5) < 1e-6
    document.saveAs(copy)
    out = "".join(capfd.readouterr())
    assert "Traceback" not in out and "could not be renamed" not in out, out
    FreeCAD.closeDocument(document.Name)
    document, design = opened(copy)
    assert (design.Verdict, design.Status, document.Tiles.Status) == ("valid", "current", "current")
    design.Label = "Old one"
    documents.take(design, documents.design_project_of(design).run(("figures", "verification")))
    assert design.Verdict == "valid" and design.MinNormalForce > 0 and len(document.Layout.Poses) == 24 * 6


def save_the_first_version(copy):
    document, design = opened(OLD)
    assert design.H_body.Value == 3 and document.Tiles.Design == design
    document.saveAs(str(copy))


def test_the_first_version_without_the_native_module(elsewhere, tmp_path):
    """What can't be read now is left as it is, to be brought up to date later."""
    said = elsewhere(save_the_first_version, tmp_path / "kept.FCStd", home="no native")[1]
    assert "older version" in said and "Traceback" not in said, said
    document, design = opened(tmp_path / "kept.FCStd")
    assert design.HBody.Value == 3 and design.Tiles == document.Tiles and design.TileCount == 24


def window_of_0_1_0(path):
    """Classes of the views that a window attaches, and whether the overlay has a scene."""
    from curveups.window.overlays import overlay_of
    from robot import settle, until

    document, design = opened(path)
    until(lambda: overlay_of(design).scene is not None, 20, "a picture")
    settle(2000)
    return {part: type(getattr(design, part).ViewObject.Proxy).__name__ for part in PARTS}


def test_a_document_of_0_1_0(elsewhere):
    """It stored the origins of its results as four texts, and its views under other names."""
    document, design = opened(RELEASED)
    document.recompute()
    assert (design.Verdict, design.Status) == ("valid", "current"), list(design.Reasons)
    assert not {"Solved", "Judged", "Rebuilt", "ResultsDigest"} & set(design.PropertiesList)
    before = design.CreaseAngle
    design.CreaseAngle = 20
    assert design.Verdict == design.Target.Status == "out of date"
    design.CreaseAngle = before
    FreeCAD.closeDocument(document.Name)
    check_whole(RELEASED)
    views, _ = elsewhere(window_of_0_1_0, str(RELEASED), window=True)
    assert views == {"Cuts": "CutsView", "Layout": "LayoutView", "Verification": "VerificationView",
                     **dict.fromkeys(("Target", "Tiles", "Support", "Anchors"), views["Tiles"])}
