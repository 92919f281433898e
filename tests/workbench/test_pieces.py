# SPDX-License-Identifier: LGPL-2.1-or-later
"""A closed target in pieces, in a document without a window."""

import FreeCAD
import pytest
from curveups.base.errors import CurveUpsError
from curveups.features import actions, document
from shapes import obj_text, sphere

pytestmark = pytest.mark.freecad


def test_a_ball_in_pieces(tmp_path):
    ball = tmp_path / "ball.obj"
    ball.write_text(obj_text(*sphere(25, 3)))
    saved = str(tmp_path / "saved.FCStd")
    doc = FreeCAD.newDocument("pieces")
    design = document.new_design(doc, str(ball))
    design.Pieces = "auto"
    actions.solve(design)
    doc.recompute()
    assert design.Verdict == "valid", (design.Verdict, list(design.Reasons))
    project = document.project_of(design)
    division, first = project.latest("division"), project.latest("design").design
    assert set(division.piece.tolist()) == {0, 1} and len(first.cuts) == len(division.edges) > 10
    assert list(design.Cuts.Edges) == []  # nobody asked for a cut
    doc.recompute()
    assert design.Status == "current", list(design.Reasons)
    name = str(doc.Name)
    doc.saveAs(saved)
    FreeCAD.closeDocument(name)
    doc = FreeCAD.openDocument(saved)
    design = doc.Design
    project = document.project_of(design)
    assert project.out_of_date("verification") == (), project.out_of_date("verification")
    design.Pieces = "3"
    doc.recompute()
    assert design.Status == "out of date" and "Solve" in design.Reasons[0], list(design.Reasons)
    assert document.project_of(design).out_of_date("layout") == ("pieces",)
    design.Pieces = "some"
    with pytest.raises(CurveUpsError, match="1 to 24"):
        document.settings_of(design)
    design.Pieces = "auto"
    doc.recompute()
    assert design.Status == "current", list(design.Reasons)
