# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document in FreeCAD: reopening, recomputing, errors, and a FreeCAD without the workbench."""

import json
import re

import FreeCAD
import pytest
from curveups.base.native import native
from curveups.base.parameters import table
from curveups.features import properties
from curveups.features.document import design_project_of, settings_of

pytestmark = pytest.mark.freecad


def opened(path):
    document = FreeCAD.openDocument(str(path))
    return document, document.Design, document.Tiles


def test_objects_and_their_shapes(dome_document):
    said = json.loads((dome_document.parent / "report.json").read_text(encoding="utf-8"))["print"]
    document, design, tiles = opened(dome_document)
    assert all("Up-to-date" in obj.State for obj in document.Objects), [o.State for o in document.Objects]
    assert len(tiles.Shape.Solids) == 54
    assert abs(tiles.Shape.Volume / 1000 - said["tile_volume_cm3"]) < 1e-6
    assert abs(document.Support.Shape.Volume / 1000 - said["support_volume_cm3"]) < 1e-4
    assert abs(document.Anchors.Shape.Volume / 1000 - said["anchor_volume_cm3"]) < 1e-4
    assert document.Target.Mesh.CountFacets == 54
    box = tiles.Shape.BoundBox
    assert abs(box.ZMin) < 1e-6 and abs(box.ZMax - 5) < 1e-6


def test_every_parameter_is_a_property_with_unit_group_and_tooltip(dome_document):
    json_path = dome_document.parent / "design.json"
    document, design, tiles = opened(dome_document)
    kept = native.read_design(json_path.read_text(encoding="utf-8")).parameters
    assert {row.group for row in table()} - {row.group for row in properties.rows()} == {
        "Stages"}
    for row in properties.rows():
        name = properties.property_name(row.name)
        assert name[0].isupper() and "_" not in name
        assert design.getGroupOfProperty(name)[2:] == row.group + ("" if row.basic else ", more")
        tip = design.getDocumentationOfProperty(name)
        assert tip.startswith(row.meaning)
        follows = {"rebuild": "at once", "verify": "Verify", "layout": "Solve", "files": "next export"}
        assert follows[row.effect] in tip, tip
        assert properties.parameter_of(name) is row
        kind = design.getTypeIdOfProperty(name)
        assert (kind == "App::PropertyLength") == (row.unit == "mm"), row.name
        assert (kind == "App::PropertyPressure") == (row.unit == "MPa"), row.name
        value = properties.value_of(design, name)
        expected = kept.get(row.name)
        assert value == expected or abs(value - expected) < 1e-12 * abs(expected), row.name
        assert "ReadOnly" not in design.getEditorMode(name), row.name
        assert settings_of(design).get(row.name) == expected, row.name  # to the last bit
    assert design.ShearModulusFront.getValueAs("kPa").Value == 1000 * kept.get("shear_modulus_front")
    names = [properties.property_name(row.name) for row in properties.rows()]
    groups = sorted({design.getGroupOfProperty(name) for name in names})
    heads = [group[2:] for group in groups]
    assert [name for name in heads if ", more" not in name] == [
        "Target", "Tiles", "Layout", "Physics", "Repair", "Bumps", "Support", "Anchors", "Files"]
    assert all(f"{name}, more" == heads[heads.index(name) + 1] for name in ("Target", "Layout"))
    assert design.CurveUpsVersion


def test_the_layout_is_kept_bit_for_bit(dome_document):
    json_path = dome_document.parent / "design.json"
    document, design, tiles = opened(dome_document)
    kept = native.write_design(design_project_of(design).latest("design").design)
    assert kept == json_path.read_text(encoding="utf-8")


def test_geometry_follows_its_properties_without_solving(dome_document):
    document, design, tiles = opened(dome_document)
    before, layout = tiles.Shape.Volume, design.Results
    design.HPin = 0.8
    document.recompute()
    assert design.Results == layout
    box = tiles.Shape.BoundBox
    assert abs(box.ZMax - 4.6) < 1e-6, box
    assert tiles.Shape.Volume < before
    assert abs(document.Anchors.Shape.BoundBox.ZMax - 4.6) < 1e-6
    assert len(tiles.Shape.Solids) == 54 and tiles.Shape.isValid()
    assert design.Verdict == "out of date", design.Reasons
    assert design.Reasons == ["HPin changed since the design was judged: Verify brings it up to date"]
    design.HPin = 1.0
    document.recompute()
    assert abs(tiles.Shape.Volume / before - 1) < 1e-12
    design.WithAnchors = False
    design.SupportKind = "breakaway"
    document.recompute()
    assert all("Up-to-date" in obj.State for obj in document.Objects), [o.State for o in document.Objects]
    assert len(document.Anchors.Shape.Solids) == 0


def test_interfaces_that_lose_their_bumps_are_said(capfd, dome_document):
    document, design, tiles = opened(dome_document)
    design.BumpHeight = 1.1
    document.recompute()
    assert design.Status == "invalid"  # walls that are recessed for them leave pins no room
    out = "".join(capfd.readouterr())
    assert re.search(r"Design: [1-9]\d* interfaces carry no bumps", out), out
