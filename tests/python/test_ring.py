# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stretching rings: what they are made of, how they close, and what they carry."""

import ezdxf
import numpy as np
import pytest
from matplotlib.path import Path as Outline

from curveups.base import freecad_session
from curveups.base.native import native
from curveups.kit import ring as rings, ring_sheet
from curveups.stages.sheets import sheets
from curveups.stages.solids import check_solids
from curveups.stages.stage import Job

HALF_SPHERE, SPOT = (195.4, 194.3), (505.0, 396.6)
J750, FDM, RESIN = (490, 390, 200), (250, 210, 210), (218, 123, 250)
SIDES = ("front", "back")


def block_of(box):
    return sheets(box, native.Parameters())


@pytest.mark.parametrize("box", [HALF_SPHERE, SPOT, (60.0, 300.0)])
@pytest.mark.parametrize("height", [5.0, 2.4])
def test_rings_close_without_their_teeth_meeting_anything(box, height):
    block = block_of(box)
    ring, middle = rings.rings(block, height, J750), np.array(rings.outer_size(block)) / 2
    front, back = (rings.teeth(block, side) for side in SIDES)
    assert len(front) == len(back) == ring["teeth"]
    for mirrored in ((-1, 1), (1, -1)):  # the back's ring is turned over onto the front's
        facing = (back - middle) * mirrored + middle
        assert np.linalg.norm(front[:, None] - facing, axis=2).min() > 2 * ring["dowel_mm"]
    assert ring["tooth_height_mm"] + 0.49 < ring["apart_mm"] == height  # nor is the other sheet met
    for places in (front, back):
        outside = abs(places - middle) - np.array(block["window_mm"]) / 2
        assert outside.max(1).min() > ring["dowel_mm"] / 2 + 2  # wood around them
        assert (middle - abs(places - middle)).min() > ring["dowel_mm"] / 2 + 2


@pytest.mark.parametrize("box, bed", [(HALF_SPHERE, J750), (HALF_SPHERE, FDM), (HALF_SPHERE, RESIN),
                                      (SPOT, J750), (SPOT, FDM), ((60.0, 300.0), FDM)])
def test_parts_fit_their_bed_and_make_up_the_ring(box, bed):
    block = block_of(box)
    whole = np.prod(rings.outer_size(block)) - np.prod(block["window_mm"])
    for side in SIDES:
        parts = ring_sheet.parts(block, side, bed, 0.1)
        assert len(parts) == max(1, len(rings.cuts(block, side, bed)))
        areas = [area_of(outline) - area_of(window) for outline, window, _, _ in parts]
        assert 0.99 * whole < sum(areas) <= whole + 1e-6  # what is free between them is little
        assert sum(len(teeth) for *_, teeth, _ in parts) == len(rings.teeth(block, side))
        assert sum(len(holes) for *_, holes in parts) == 4
        for outline, _, teeth, _ in parts:
            assert all(a + 10 <= b for a, b in zip(sorted(np.ptp(outline, axis=0)), sorted(bed[:2])))
            if len(parts) > 1:
                assert distance(teeth, outline).min() > 2.5 + 1.3
        for (one, *_), (two, *_) in zip(parts, parts[1:] * (len(parts) > 1)):
            away = distance(one, two)
            facing = away < 1
            assert facing.sum() >= 6 and away[facing].min() > 0.089 and away[facing].max() < 0.142
            assert not any(Outline(two).contains_points(one[facing]))


def area_of(polygon):
    x, y = np.reshape(polygon, (-1, 2)).T
    return 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


def distance(points, outline):
    along = np.roll(outline, -1, axis=0) - outline
    share = np.einsum("pnk,nk->pn", points[:, None] - outline, along) / np.einsum("nk,nk->n", along, along)
    return np.linalg.norm(points[:, None] - outline - share.clip(0, 1)[..., None] * along, axis=2).min(1)


@pytest.mark.parametrize("box, bed, count", [(HALF_SPHERE, J750, 1), (HALF_SPHERE, FDM, 4), (SPOT, J750, 4),
                                             (SPOT, FDM, 8)])
def test_solids_are_sound_and_read_by_other_programs(tmp_path, box, bed, count):
    _, part, mesh = freecad_session.load("Part", "Mesh")
    block = block_of(box)
    ring = rings.rings(block, 5.0, bed)
    for side in SIDES:
        model = ring_sheet.solids("a ring", block, side, ring, {"bed_mm": bed, "tolerance_mm": 0.1})
        assert check_solids(model, True, Job()) == ([], [body.name for body in model.bodies("tiles")])
        for ending in ("step", "stl"):
            model.write(ending, "print", str(tmp_path / f"ring.{ending}"))
        shape = part.read(str(tmp_path / "ring.step"))
        assert len(shape.Solids) == count == ring[side]["parts"] and shape.isValid()
        assert shape.Volume == pytest.approx(model.volumes["tiles"], rel=1e-6)
        assert shape.BoundBox.ZMax == pytest.approx(ring["thickness_mm"] + ring["tooth_height_mm"])
        printed = mesh.Mesh(str(tmp_path / "ring.stl"))
        assert printed.isSolid() and printed.countComponents() == count
        assert printed.Volume == pytest.approx(shape.Volume, rel=1e-3)


def test_the_plywood_has_the_same_teeth(tmp_path):
    block = block_of(HALF_SPHERE)
    for side in SIDES:
        path = tmp_path / "ring.dxf"
        path.write_bytes(ring_sheet.dxf(ring_sheet.frame("a ring", block, side, 12.0)))
        space = ezdxf.readfile(path).modelspace()
        outer, window = (np.array([p[:2] for p in line]) for line in space.query('LWPOLYLINE[layer=="cut"]'))
        assert np.allclose(np.ptp(outer, axis=0), rings.outer_size(block))
        assert np.allclose(np.ptp(window, axis=0), block["window_mm"])
        assert len(space.query('CIRCLE[layer=="cut"]')) == 4
        holes = np.array([tuple(c.dxf.center)[:2] for c in space.query('CIRCLE[layer=="control"]')])
        assert np.allclose(holes, rings.teeth(block, side))


@pytest.mark.parametrize("box, bed", [(HALF_SPHERE, J750), (HALF_SPHERE, RESIN), (SPOT, J750), (SPOT, FDM)])
def test_rings_give_way_by_less_than_a_millimetre(box, bed):
    ring = rings.rings(block_of(box), 5.0, bed)
    for side in SIDES:
        assert max(ring[side]["bends_mm"] + ring[side]["rises_mm"]) < 1.0
        assert ring[side]["tooth_mpa"] < 20  # photopolymers and beech break at 50 and more
    assert ring["front"]["tooth_n"] == pytest.approx(15 * 0.36 * (1 - 3 ** -6))


@pytest.mark.parametrize("box, most", [(HALF_SPHERE, 81), (SPOT, 189)])
def test_sheets_pull_with_their_tension_over_the_window(box, most):
    """G h (1 - tau^-6) over the longer side: 80 N and 190 N in round numbers."""
    block = block_of(box)
    for side in SIDES:
        assert sorted(block["load_n"][side]) == pytest.approx(
            sorted(0.36 * (1 - 3 ** -6) * length for length in block["window_mm"]))
        assert max(block["load_n"][side]) == pytest.approx(most, abs=0.6)


def test_a_square_ring_bends_as_beams_held_at_both_ends_and_in_shear():
    """Corners of a square do not turn: q L^4 / 384 E I."""
    block = block_of((205.0, 205.0))
    ring = rings.rings(block, 5.0, J750)
    span, width, thickness, pull = 277.5, 52.5, ring["thickness_mm"], 0.36 * (1 - 3 ** -6)
    bending = pull * span ** 4 / (384 * 2000 * thickness * width ** 3 / 12)
    shear = pull * span ** 2 / 8 / (5 / 6 * 2000 / 2.7 * width * thickness)
    assert ring["front"]["bends_mm"] == pytest.approx([bending + shear] * 2)


def test_teeth_that_are_wider_than_high_are_refused():
    square = np.array([(0, 0), (9, 0), (9, 9), (0, 9)], float)
    for sizes in ((0.0, 1.0, 2.0), (1.0, 2.0, 2.0)):
        with pytest.raises(native.InvalidInput, match="make no teeth"):
            native.make_ring("a", [(square, [], [], [])], *sizes)
    with pytest.raises(native.InvalidInput, match="three corners"):
        native.make_ring("a", [(square[:2], [], [], [])], 1.0, 1.0, 2.0)
