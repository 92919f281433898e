# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents stay whole wherever they were saved: without the workbench, without its native module."""

import sys

import FreeCAD
import pytest
from curveups.base.native import problem
from curveups.features import document as documents

pytestmark = pytest.mark.freecad

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
    document.recompute()
    assert design.Verdict == "out of date"
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
        document.recompute()
        assert (design.Verdict, design.Status) == ("out of date", "out of date"), name
        assert name in design.Reasons[0] and getattr(design, part).Status == "out of date", name
        setattr(design, name, kept)
        document.recompute()
        assert design.Verdict == "valid", (name, list(design.Reasons))
    design.setExpression("Tau", "1.5 + 1")
    document.recompute()
    assert design.Verdict == "out of date" and len(document.Tiles.Shape.Solids) == 54
    document.saveAs(str(edited))


def test_without_the_native_module(dome_document, elsewhere, tmp_path):
    """The document opens, states follow an edit by comparison alone, and the saved file is whole."""
    same, edited = tmp_path / "same.FCStd", tmp_path / "edited.FCStd"
    said = elsewhere(open_and_edit, dome_document, same, edited, home="no native")[1]
    assert "Traceback" not in said, said
    check_whole(same)
    document, design = opened(edited)
    assert design.Verdict == "out of date" and design.Tau == 2.5, (design.Verdict, design.Tau)
    design.setExpression("Tau", None)
    design.Tau = 3
    document.recompute()
    assert design.Verdict == "valid", list(design.Reasons)
