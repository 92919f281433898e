# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document in FreeCAD: reopening, recomputing, errors, and a FreeCAD without the workbench."""

import json
import re
import struct
import zipfile
import zlib

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
from curveups.features.document import settings_of
from curveups.base.native import native
kept = native.read_design(open(json_path, encoding='utf-8').read()).parameters
assert {row.group for row in native.parameter_table()} - {row.group for row in properties.rows()} == {
    'Stages'}
for row in properties.rows():
    name = properties.property_name(row.name)
    assert name[0].isupper() and '_' not in name
    assert design.getGroupOfProperty(name).endswith(' ' + row.group)
    tip = design.getDocumentationOfProperty(name)
    assert tip.startswith(row.meaning)
    follows = {'rebuild': 'at once', 'verify': 'Verify', 'layout': 'Solve', 'files': 'next export'}
    assert follows[row.tier] in tip, tip
    assert properties.tier_of(design, name) == row.tier, row.name
    kind = design.getTypeIdOfProperty(name)
    assert (kind == 'App::PropertyLength') == (row.unit == 'mm'), row.name
    assert (kind == 'App::PropertyPressure') == (row.unit == 'MPa'), row.name
    value = properties.value_of(design, name)
    expected = kept.get(row.name)
    assert value == expected or abs(value - expected) < 1e-12 * abs(expected), row.name
    assert 'ReadOnly' not in design.getEditorMode(name), row.name
    assert settings_of(design).get(row.name) == expected, row.name  # to the last bit
assert design.ShearModulusFront.getValueAs('kPa').Value == 1000 * kept.get('shear_modulus_front')
groups = sorted({design.getGroupOfProperty(properties.property_name(row.name)) for row in properties.rows()})
assert [group[2:] for group in groups] == ['Target', 'Tiles', 'Layout', 'Physics', 'Repair', 'Bumps',
                                           'Support', 'Anchors', 'Files']
assert design.CurveUpsVersion
done()
""", path=document, json_path=document.parent / "design.json")


def test_the_layout_is_kept_bit_for_bit(freecad, document):
    freecad(OPEN + """
from curveups.features.document import design_project_of
from curveups.base.native import native
kept = native.write_design(design_project_of(design).latest('design').design)
assert kept == open(json_path, encoding='utf-8').read()
done()
""", path=document, json_path=document.parent / "design.json")


def test_the_same_design_is_the_same_file(document, designed, tmp_path):
    """But for where its target lies, and the digest of the results, which say it."""
    again = designed(tmp_path)

    def content(path, folder):
        with zipfile.ZipFile(path) as archive:
            found = {name: archive.read(name) for name in archive.namelist()}
        text = found["Document.xml"].replace(str(folder).encode(), b"")
        found["Document.xml"] = re.sub(rb'<Property name="ResultsDigest".*?</Property>', b"", text,
                                       flags=re.S)
        return found

    assert content(document, document.parents[1]) == content(again, tmp_path)


def test_the_file_has_a_thumbnail(document):
    with zipfile.ZipFile(document) as archive:
        png = archive.read("thumbnails/Thumbnail.png")
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", png[16:24]) == (128, 128)
    rows = zlib.decompress(png[41:41 + struct.unpack(">I", png[33:37])[0]])
    pixels = [rows[k * 513 + 1 + 4 * j: k * 513 + 5 + 4 * j] for k in range(128) for j in range(128)]
    drawn = sum(pixel[3] > 0 for pixel in pixels) / len(pixels)
    assert 0.3 < drawn < 0.9 and len({bytes(pixel) for pixel in pixels}) > 40


def test_save_and_reopen(freecad, document, tmp_path):
    freecad(OPEN + """
layout, volume = design.Layout.Poses, tiles.Shape.Volume
document.saveAs(copy)
FreeCAD.closeDocument(document.Name)
again = FreeCAD.openDocument(copy)
assert again.Design.Layout.Poses == layout and len(layout) == 54 * 6
assert abs(again.Tiles.Shape.Volume / volume - 1) < 1e-12
assert type(again.Design.Proxy).__name__ == 'DesignProxy'
again.Design.touch()
again.recompute()
assert abs(again.Tiles.Shape.Volume / volume - 1) < 1e-12
done()
""", path=document, copy=tmp_path / "copy.FCStd")


def test_geometry_follows_its_properties_without_solving(freecad, document):
    freecad(OPEN + """
before, layout = tiles.Shape.Volume, design.Results
design.HPin = 0.8
document.recompute()
assert design.Results == layout
box = tiles.Shape.BoundBox
assert abs(box.ZMax - 4.6) < 1e-6, box
assert tiles.Shape.Volume < before
assert abs(anchors.Shape.BoundBox.ZMax - 4.6) < 1e-6
assert len(tiles.Shape.Solids) == 54 and tiles.Shape.isValid()
assert design.Verdict == 'out of date', design.Reasons
assert design.Reasons == ['HPin changed since the design was judged: Verify brings it up to date']
design.HPin = 1.0
document.recompute()
assert abs(tiles.Shape.Volume / before - 1) < 1e-12
design.WithAnchors = False
design.SupportKind = 'breakaway'
document.recompute()
assert all('Up-to-date' in obj.State for obj in document.Objects), [o.State for o in document.Objects]
assert len(anchors.Shape.Solids) == 0
done()
""", path=document)


def test_constraints_that_no_longer_hold_are_said(freecad, bowl):
    """The back faces of a bowl's thicker tiles are larger: gaps on the back close."""
    freecad(OPEN + """
layout = design.Results
design.HBody = 4.0
document.recompute()
assert design.Verdict == 'not valid', (design.Verdict, design.Reasons)
assert any('nearer than DGapMin' in reason for reason in design.Reasons), design.Reasons
assert design.Results == layout
done()
""", path=bowl)


def test_a_value_that_can_not_be_built_keeps_the_old_shapes(freecad, document):
    out = freecad(OPEN + """
volume = tiles.Shape.Volume
design.HBody = 45.0     # deeper than the dome's radius: back faces turn over
document.recompute()
assert (design.Status, design.Verdict) == ('invalid', 'not valid')
assert tiles.Status == 'out of date' and 'HBody' in tiles.Reason
assert abs(tiles.Shape.Volume / volume - 1) < 1e-12
design.HBody = 3.0
document.recompute()
assert (design.Status, design.Verdict, tiles.Status) == ('current', 'valid', 'current')
assert abs(tiles.Shape.Volume / volume - 1) < 1e-12
done()
""", path=document)
    assert re.search(r"[1-9]\d* back faces vanish \(Design, T000", out), out


def test_interfaces_that_lose_their_bumps_are_said(freecad, document):
    out = freecad(OPEN + """
design.BumpDiameter = 9.9
document.recompute()
assert design.Status == 'out of date'
done()
""", path=document)
    assert re.search(r"Design: [1-9]\d* interfaces carry no bumps", out), out


def test_out_of_range_value_is_an_error_with_the_range(freecad, document):
    out = freecad(OPEN + """
design.HPin = 999
document.recompute()
assert design.Status == 'invalid' and 'HPin' in design.Reasons[0]
done()
""", path=document)
    assert "HPin" in out and "50.00 mm" in out and "Traceback" not in out, out


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
""", home=False, path=document, copy=tmp_path / "foreign.FCStd")
    # ... and nothing is lost when it was saved there.
    freecad(OPEN + """
assert len(tiles.Shape.Solids) == 54 and design.Results and design.Layout is document.Layout
done()
""", path=tmp_path / "foreign.FCStd")
