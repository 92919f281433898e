# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document in FreeCAD: reopening, recomputing, errors, and a FreeCAD without the workbench."""

import json
import re

OPEN = """
import FreeCAD
document = FreeCAD.openDocument(path)
design, tiles = document.Design, document.Tiles
support, anchors, target = document.Support, document.Anchors, document.Target
"""


def test_objects_and_their_shapes(freecad, document):
    report = json.loads((document.parent / "report.json").read_text())
    freecad(OPEN + f"""
assert all('Up-to-date' in obj.State for obj in document.Objects), [o.State for o in document.Objects]
assert len(tiles.Shape.Solids) == 54
assert abs(tiles.Shape.Volume / 1000 - {report["print"]["tile_volume_cm3"]}) < 1e-6
assert abs(support.Shape.Volume / 1000 - {report["print"]["support_volume_cm3"]}) < 1e-4
assert abs(anchors.Shape.Volume / 1000 - {report["print"]["anchor_volume_cm3"]}) < 1e-4
assert target.Mesh.CountFacets == 54
box = tiles.Shape.BoundBox
assert abs(box.ZMin) < 1e-6 and abs(box.ZMax - 5) < 1e-6
done()
""", path=document)


def test_every_parameter_is_a_property_with_unit_group_and_tooltip(freecad, document):
    freecad(OPEN + """
from curveups.features import properties
from curveups.native import native
kept = native.read_design(design.Layout).parameters
for row in native.parameter_table():
    if row.group in ('Files', 'Stages'):
        continue
    assert design.getGroupOfProperty(row.name) == row.group
    assert design.getDocumentationOfProperty(row.name).startswith(row.meaning)
    kind = design.getTypeIdOfProperty(row.name)
    assert (kind == 'App::PropertyLength') == (row.unit == 'mm'), row.name
    assert (kind == 'App::PropertyPressure') == (row.unit == 'MPa'), row.name
    value = properties.value_of(design, row)
    expected = kept.get(row.name)
    assert value == expected or abs(value - expected) < 1e-12 * abs(expected), row.name
    read_only = 'ReadOnly' in design.getEditorMode(row.name)
    assert read_only == (row.tier != 'rebuild'), row.name
assert design.shear_modulus_front.getValueAs('kPa').Value == 1000 * kept.get('shear_modulus_front')
assert design.CurveUpsVersion
done()
""", path=document)


def test_the_layout_is_kept_bit_for_bit(freecad, document):
    freecad(OPEN + """
assert design.Layout == open(json_path, encoding='utf-8').read()
done()
""", path=document, json_path=document.parent / "design.json")


def test_save_and_reopen(freecad, document, tmp_path):
    freecad(OPEN + """
layout, volume = design.Layout, tiles.Shape.Volume
document.saveAs(copy)
FreeCAD.closeDocument(document.Name)
again = FreeCAD.openDocument(copy)
assert again.Design.Layout == layout
assert abs(again.Tiles.Shape.Volume / volume - 1) < 1e-12
assert type(again.Design.Proxy).__name__ == 'DesignProxy'
again.Design.touch()
again.recompute()
assert abs(again.Tiles.Shape.Volume / volume - 1) < 1e-12
done()
""", path=document, copy=tmp_path / "copy.FCStd")


def test_geometry_follows_its_properties_without_solving(freecad, document):
    freecad(OPEN + """
before, layout = tiles.Shape.Volume, design.Layout
design.H_pin = 0.8
document.recompute()
assert design.Layout == layout
box = tiles.Shape.BoundBox
assert abs(box.ZMax - 4.6) < 1e-6, box
assert tiles.Shape.Volume < before
assert abs(anchors.Shape.BoundBox.ZMax - 4.6) < 1e-6
assert len(tiles.Shape.Solids) == 54 and tiles.Shape.isValid()
assert design.Verdict == 'not judged', design.Reasons
assert design.Reasons == ['geometry changed since verification (H_pin)']
design.H_pin = 1.0
document.recompute()
assert abs(tiles.Shape.Volume / before - 1) < 1e-12
design.anchors = False
design.support = 'breakaway'
document.recompute()
assert all('Up-to-date' in obj.State for obj in document.Objects), [o.State for o in document.Objects]
assert len(anchors.Shape.Solids) == 0
done()
""", path=document)


def test_constraints_that_no_longer_hold_are_said(freecad, bowl):
    """The back faces of a bowl's thicker tiles are larger: gaps on the back close."""
    freecad(OPEN + """
layout = design.Layout
design.H_body = 4.0
document.recompute()
assert design.Verdict == 'not valid', (design.Verdict, design.Reasons)
assert any('nearer than d_gap_min' in reason for reason in design.Reasons), design.Reasons
assert design.Layout == layout
done()
""", path=bowl)


def test_a_value_that_can_not_be_built_keeps_the_old_shapes(freecad, document):
    out = freecad(OPEN + """
volume = tiles.Shape.Volume
design.H_body = 45.0     # deeper than the dome's radius: back faces turn over
document.recompute()
assert 'Invalid' in design.State, design.State
assert abs(tiles.Shape.Volume / volume - 1) < 1e-12
design.H_body = 3.0
document.recompute()
assert 'Up-to-date' in design.State
assert abs(tiles.Shape.Volume / volume - 1) < 1e-12
done()
""", path=document)
    assert re.search(r"[1-9]\d* back faces vanish \(Design, T000", out), out


def test_interfaces_that_lose_their_bumps_are_said(freecad, document):
    out = freecad(OPEN + """
design.bump_diameter = 9.9
document.recompute()
assert 'Up-to-date' in design.State
done()
""", path=document)
    assert re.search(r"Design: [1-9]\d* interfaces carry no bumps", out), out


def test_out_of_range_value_is_an_error_with_the_range(freecad, document):
    out = freecad(OPEN + """
design.H_pin = 999
document.recompute()
assert 'Invalid' in design.State
done()
""", path=document)
    assert "H_pin" in out and "50 mm" in out, out


def test_shapes_survive_without_the_workbench(freecad, document, tmp_path):
    freecad(OPEN + """
import sys
assert not any('CurveUps' in p for p in sys.path)
assert len(tiles.Shape.Solids) == 54
volume = tiles.Shape.Volume
assert support.Shape.Volume > 0 and anchors.Shape.Volume > 0
document.recompute()
assert abs(tiles.Shape.Volume / volume - 1) < 1e-12
document.saveAs(copy)
done()
""", with_workbench=False, path=document, copy=tmp_path / "foreign.FCStd")
    # ... and nothing is lost when it was saved there.
    freecad(OPEN + """
assert len(tiles.Shape.Solids) == 54 and design.Layout
done()
""", path=tmp_path / "foreign.FCStd")
