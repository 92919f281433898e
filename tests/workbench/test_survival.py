# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents stay whole wherever they were saved: without the workbench, without its native module, by
the first version."""

from pathlib import Path

import pytest

OLD = Path(__file__).parent / "data" / "first-version.FCStd"

OPEN = """
import FreeCAD
document = FreeCAD.openDocument(path)
design = document.Design
PARTS = ('Target', 'Cuts', 'Layout', 'Verification', 'Tiles', 'Support', 'Anchors')
"""
WHOLE = OPEN + """
from curveups.features import document as documents
assert type(design.Proxy).__name__ == 'DesignProxy'
assert type(document.Tiles.Proxy).__name__ == 'BodiesProxy'
assert (design.Verdict, design.Status) == ('valid', 'current'), list(design.Reasons)
assert [getattr(design, part).Status for part in PARTS] == ['current'] * 7
before = document.Tiles.Shape.Volume
design.HPin = '0.8 mm'
assert design.Verdict == 'out of date'
document.recompute()
assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.6) < 1e-6 and document.Tiles.Status == 'current'
documents.take(design, documents.design_project_of(design).run(('figures', 'verification')))
assert (design.Verdict, design.Status) == ('valid', 'current'), list(design.Reasons)
done()
"""


def test_saved_without_the_workbench(freecad, document, tmp_path):
    foreign, again = tmp_path / "foreign.FCStd", tmp_path / "again.FCStd"
    freecad(OPEN + """
import sys
assert not any('CurveUps' in p for p in sys.path)
assert len(document.Tiles.Shape.Solids) == 54
document.recompute()
document.saveAs(copy)
FreeCAD.closeDocument(document.Name)
FreeCAD.openDocument(copy).saveAs(again)
done()
""", home=False, path=document, copy=foreign, again=again)
    freecad(WHOLE, path=again)


def test_edited_without_the_workbench(freecad, document, tmp_path):
    copy = tmp_path / "edited.FCStd"
    freecad(OPEN + """
design.HBody = '2.5 mm'
document.recompute()
document.saveAs(copy)
done()
""", home=False, path=document, copy=copy)
    freecad(OPEN + """
assert design.Verdict == 'out of date' and 'HBody' in design.Reasons[0], list(design.Reasons)
assert document.Tiles.Status == 'out of date' and document.Layout.Status == 'current'
document.recompute()
assert abs(document.Tiles.Shape.BoundBox.ZLength - 4.5) < 1e-6
done()
""", path=copy)


@pytest.mark.parametrize("home", ["no native", "broken native"])
def test_without_the_native_module(freecad, document, tmp_path, home):
    """It opens and shows; an edit is noticed, by comparison alone; what was saved is whole."""
    same, edited = tmp_path / "same.FCStd", tmp_path / "edited.FCStd"
    out = freecad(OPEN + """
from curveups.base.native import problem
assert 'run tools/setup' in str(problem())
assert type(design.Proxy).__name__ == 'DesignProxy'
assert (design.Verdict, design.Status) == ('valid', 'current'), list(design.Reasons)
document.recompute()
document.saveAs(same)
for name, value, part in (('HBody', '2.5 mm', 'Tiles'), ('Tau', 2.5, 'Layout'),
                          ('FrictionCoefficient', 0.4, 'Verification')):
    kept = getattr(design, name)
    setattr(design, name, value)
    assert (design.Verdict, design.Status) == ('out of date', 'out of date'), name
    assert name in design.Reasons[0] and getattr(design, part).Status == 'out of date', name
    setattr(design, name, kept)
    assert design.Verdict == 'valid', (name, list(design.Reasons))
design.setExpression('Tau', '1.5 + 1')
document.recompute()
assert design.Verdict == 'out of date' and len(document.Tiles.Shape.Solids) == 54
document.saveAs(edited)
done()
""", home=home, path=document, same=same, edited=edited)
    assert "Traceback" not in out, out
    freecad(WHOLE, path=same)
    freecad(OPEN + """
assert design.Verdict == 'out of date' and design.Tau == 2.5, (design.Verdict, design.Tau)
design.setExpression('Tau', None)
design.Tau = 3
assert design.Verdict == 'valid', list(design.Reasons)
done()
""", path=edited)


def test_a_document_of_the_first_version(freecad, tmp_path):
    """Its parameters, expressions on them and expressions that read them, its verdict, its shapes."""
    copy = tmp_path / "migrated.FCStd"
    out = freecad(OPEN + """
figures, values, tiles = document.Figures, document.Values, document.Tiles
assert (design.TileCount, len(tiles.Shape.Solids)) == (24, 24)
assert [getattr(design, part).Name for part in PARTS] == list(PARTS)
assert design.SupportKind == 'none' and not design.WithAnchors and design.Bumps == 'none'
assert not {'H_body', 'tau', 'SolvedVerdict', 'd_gap_min'} & set(design.PropertiesList)
# Two values were changed since it was judged: no verdict is taken over for them.
assert design.Verdict == 'out of date' and 'HPin' in design.Reasons[0], list(design.Reasons)
assert tiles.Status == 'current' and abs(tiles.Shape.BoundBox.ZLength - 4.8) < 1e-6
assert figures.getContents('A1') == '=Design.HBody * 2' and figures.getContents('D1').endswith('text')
assert sorted(design.ExpressionEngine) == [('BumpHeight', 'HPin / 4'), ('HPin', 'Values.B2')]
document.recompute()
assert figures.A1.Value == 6 and abs(figures.C3.Value - 1.6) < 1e-9 and document.Box.Length.Value == 8
values.set('B2', '=1 mm')
document.recompute()
assert (design.HPin.Value, design.BumpHeight.Value, design.Verdict) == (1, 0.25, 'valid')
assert abs(tiles.Shape.BoundBox.ZLength - 5) < 1e-6
document.saveAs(copy)
done()
""", path=OLD, copy=copy)
    assert "Traceback" not in out and "could not be renamed" not in out, out
    freecad(OPEN + """
from curveups.features import document as documents
assert (design.Verdict, design.Status, document.Tiles.Status) == ('valid', 'current', 'current')
design.Label = 'Old one'
documents.take(design, documents.design_project_of(design).run(('figures', 'verification')))
assert design.Verdict == 'valid' and design.MinNormalForce > 0 and len(document.Layout.Poses) == 24 * 6
done()
""", path=copy)


def test_the_first_version_without_the_native_module(freecad, tmp_path):
    """What can't be read now is left as it is, to be brought up to date later."""
    copy = tmp_path / "kept.FCStd"
    out = freecad(OPEN + """
assert design.H_body.Value == 3 and document.Tiles.Design == design
document.saveAs(copy)
done()
""", home="no native", path=OLD, copy=copy)
    assert "older version" in out and "Traceback" not in out, out
    freecad(OPEN + """
assert design.HBody.Value == 3 and design.Tiles == document.Tiles and design.TileCount == 24
done()
""", path=copy)
