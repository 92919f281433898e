# SPDX-License-Identifier: LGPL-2.1-or-later
"""In a window: tiles follow a dimension of the part, undo takes that back, Tile Anew does not follow."""

import FreeCAD
import pytest
from curveups.features import document as documents
from curveups.window.run import LIVE
from robot import close_panel, picture, press, until
from steps import begin

pytestmark = pytest.mark.freecad(window=True)


def solve(design, command="CurveUps_Solve"):
    press(command)
    until(lambda: not LIVE.busy and design.Status != "running", 200, "the run to end")
    close_panel()


def tiles_of(design):
    return list(design.Layout.Faces)


def test_tiles_follow_a_dimension(pictures):
    document = begin()
    sphere = document.addObject("Part::Sphere", "Sphere")
    sphere.Radius, sphere.Angle1 = 60, 45
    document.recompute()
    design = documents.new_design(document, sphere)
    design.L, design.Faces = 12, "Face1"
    document.recompute()
    solve(design)
    assert design.Verdict == "valid" and design.Tiling == "", design.Reasons
    first, layout = tiles_of(design), list(design.Layout.Poses)
    middle = next(v for v in first if first.count(v) == 6)
    beside = first[first.index(middle) // 3 * 3:][:3]
    documents.set_cuts(design, [[middle, next(v for v in beside if v != middle and first.count(v) > 4)]])
    solve(design)
    cuts = list(design.Cuts.Edges)
    assert design.CutCount == 1

    document.openTransaction("Edit Radius")
    sphere.Radius = 63
    document.recompute()
    document.commitTransaction()
    assert design.Verdict == "out of date"
    solve(design)
    picture("followed")
    count = len(first) // 3
    assert design.Tiling == f"the tiles follow the target: {count} kept, 0 new", design.Tiling
    assert tiles_of(design) == first and list(design.Cuts.Edges) == cuts and design.CutCount == 1
    assert design.Verdict == "valid" and list(design.Layout.Poses) != layout
    report = max(abs(vertex.Length - 63) for vertex in design.Layout.Vertices)
    assert report < 0.5, report

    document.undo()
    document.undo()
    assert str(sphere.Radius) == "60.0 mm" and design.Verdict == "valid" and design.Tiling == ""
    document.redo()
    document.redo()
    assert design.Tiling.startswith("the tiles follow") and design.Verdict == "valid"

    # Another length needs other tiles.
    solve(design, "CurveUps_TileAnew")
    assert design.Tiling == "" and design.Verdict == "valid" and design.CutCount > 0
    FreeCAD.closeDocument(document.Name)
