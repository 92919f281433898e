# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values that the overlay draws, without drawing: motions, colours, fields."""

import numpy as np
import pytest
from curveups.base.native import native
from curveups.window.overlay import colours, scene as prisms
from curveups.window.overlay.fields import CONTACT, SIDE, TILE, Field, aligned, deviation_field
from curveups.window.overlay.scene import Motion, axes_of, part_of


def rotation(axis, angle):
    axis = np.array(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


@pytest.fixture
def tiles():
    """Tiles in the plane, and where each of them goes: some of them nearly turned over."""
    random = np.random.default_rng(7)
    flat = np.zeros((40, 6, 3))
    flat[:, :3, :2] = [[0, 0], [7, 0], [3, 6]]
    flat[:, 3:, :2] = [[0.5, 0.5], [6, 0.5], [3, 5]]
    flat[:, 3:, 2] = -3
    flat += random.uniform(-60, 60, (40, 1, 3)) * [1, 1, 0]
    turns = np.stack([rotation(random.normal(size=3), angle)
                      for angle in np.linspace(0, np.pi - 1e-9, 40)])
    actuated = flat @ turns.transpose(0, 2, 1) + random.uniform(-200, 200, (40, 1, 3))
    return flat, actuated


def lengths(corners):
    return np.linalg.norm(corners[:, :, None] - corners[:, None], axis=3)


def test_a_motion_ends_where_the_tiles_are(tiles):
    flat, actuated = tiles
    motion = Motion(flat[:, :3], actuated[:, :3])
    assert np.abs(motion.move(flat, 0) - flat).max() < 1e-9
    assert np.abs(motion.move(flat, 1) - actuated).max() < 1e-9


@pytest.mark.parametrize("t", [0.1, 0.5, 0.9])
def test_tiles_stay_rigid_on_the_way(tiles, t):
    flat, actuated = tiles
    moved = Motion(flat[:, :3], actuated[:, :3]).move(flat, t)
    assert np.abs(lengths(moved) - lengths(flat)).max() < 1e-9
    # ... and are not mirrored.
    volume = np.linalg.det(moved[:, 1:4] - moved[:, :1])
    assert np.abs(volume / np.linalg.det(flat[:, 1:4] - flat[:, :1]) - 1).max() < 1e-9


def test_a_layout_that_moves_as_a_whole_stays_together_on_the_way(tiles):
    flat, _ = tiles
    whole = flat @ rotation([1, 2, 0], 3.0).T + [100, 0, 50]
    half = Motion(flat[:, :3], whole[:, :3]).move(flat, 0.5).reshape(-1, 3)
    assert np.abs(lengths(half[None]) - lengths(flat.reshape(1, -1, 3))).max() < 1e-9


@pytest.mark.parametrize("angle", [0, 1e-9, 1.0, np.pi - 1e-7, np.pi])
def test_shares_of_a_rotation(angle):
    turns = np.stack([rotation(axis, angle) for axis in ([1, 0, 0], [0, 1, 0], [0, 0, 1], [1, -2, 3])])
    assert np.abs(part_of(*axes_of(turns), 1.0) - turns).max() < 1e-7
    half = part_of(*axes_of(turns), 0.5)
    assert np.abs(half @ half - turns).max() < 1e-7


def test_normals_point_outward_and_index_every_polygon(tiles):
    flat, _ = tiles
    middle = flat.mean(1)
    normals = prisms.normals(flat)
    for topology in (prisms.THIRDS, prisms.WHOLE):
        points = prisms.with_middles(flat) if topology.points == 8 else flat
        for polygon, normal in zip(topology.polygons, topology.normal):
            corners = points[:, polygon]
            own = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 1])
            assert (np.einsum("mk,mk->m", own, corners.mean(1) - middle) > 0).all(), polygon
            assert (np.einsum("mk,mk->m", own, normals[:, normal]) > 0).all(), polygon
    index = prisms.THIRDS.coordinate_index(3)
    assert index.max() == 3 * 8 - 1 and (index == -1).sum() == 3 * len(prisms.THIRDS.polygons)


def test_pins_are_prisms_that_end_outside(tiles):
    flat, _ = tiles
    base, top = flat[:, :3], flat[:, :3] + [0, 0, 1]
    below = flat[:, 3:]
    pins = np.stack([np.concatenate([base, top], 1), np.concatenate([below, below - [0, 0, 1]], 1)], axis=1)
    found = prisms.pin_prisms(pins)
    assert found.shape == (80, 6, 3)
    assert (np.linalg.det(found[:, 1:4] - found[:, :1]) < 0).all()  # as of the tiles
    assert (np.linalg.det(flat[:, 1:4] - flat[:, :1]) < 0).all()


@pytest.mark.parametrize("name", colours.NAMES)
def test_maps_keep_their_order_as_grey(name):
    """So they do for eyes that tell no red from green."""
    grey = colours.sample(name, np.linspace(0, 1, 101)) @ [0.2126, 0.7152, 0.0722]
    if name == colours.SIGNED:  # from both ends to the middle
        assert (np.diff(grey[:51]) > 0).all() and (np.diff(grey[50:]) < 0).all()
    else:
        assert (np.diff(grey) > 0).all()


def test_colours_of_values():
    shares = colours.shares(np.array([-1.0, 2, 3, 9, np.nan, np.inf, -np.inf]), 2, 4)
    found = colours.sample("Viridis", shares)
    ends = colours.sample("Viridis", np.array([0.0, 0.5, 1.0]))
    assert np.allclose(found[[0, 1, 6]], ends[0]) and np.allclose(found[2], ends[1])
    assert np.allclose(found[[3, 5]], ends[2]) and np.allclose(found[4], colours.NOTHING)
    assert list(colours.packed(np.array([[1, 0, 0.2]]))) == [0xFF0033FF]


def test_problems_are_beyond_the_limit_and_the_worst_come_first():
    one = Field("x", "mm", TILE, lambda: [3.0, 1.0, np.nan, 0.5, 1.0 - 1e-9], "low", 1.0, "cross")
    assert list(one.problems) == [3]
    assert list(one.order) == [3, 4, 1, 0]
    sides = Field("x", "mm^2", SIDE, lambda: [[3, 1], [0.2, 5], [np.nan, 2]], "low", 0.5)
    assert list(sides.problems) == [1] and list(sides.worst) == [1, 0.2, 2]
    high = Field("x", "", CONTACT, lambda: [0.2, 0.9, 0.6], "high", 0.5)
    assert list(high.problems) == [1, 2] and list(high.order) == [1, 2, 0]
    assert not len(Field("x", "", CONTACT, lambda: [0.2], "high").problems)


def test_ranges_of_fields():
    low, high = Field("x", "", TILE, lambda: np.append(np.linspace(0, 1, 1001), 1e6)).automatic_range()
    assert 0 < low < 0.02 and 0.98 < high <= 1
    assert Field("x", "deg", TILE, lambda: [-3.0, 8.0], signed=True).automatic_range() == \
        pytest.approx((-7.89, 7.89))
    for values, signed, ends in (([2.0, 2.0], False, (1, 3)), ([0.02], False, (0.01, 0.03)),
                                 ([-3.0], True, (-3, 3)), ([0.0] * 9, True, (-1, 1)),
                                 ([0.0] * 9, False, (0, 1)), ([False] * 900 + [True], False, (0, 1))):
        found = Field("x", "", TILE, lambda: values, signed=signed).automatic_range()
        assert found == pytest.approx(ends), values
    assert Field("x", "", TILE, lambda: [np.nan]).automatic_range() == (0, 1)


def test_values_find_their_contacts():
    found = {"contact_tiles": [[5, 2], [0, 1]], "gap": [0.7, 0.4]}
    values = aligned(found, "gap", np.array([[0, 1], [2, 5], [3, 4]]))
    assert list(values[:2]) == [0.4, 0.7] and np.isnan(values[2])
    none = aligned({"contact_tiles": np.empty((0, 2)), "gap": []}, "gap", np.array([[0, 1]]))
    assert np.isnan(none).all()


def test_deviation_is_the_largest_on_each_tile():
    V = np.array([[0.0, 0, 0], [8, 0, 0], [8, 8, 0], [0, 8, 0]])
    F = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
    lifted = V + [[0, 0, 0.5], [0, 0, 0], [0, 0, 0], [0, 0, -2]]
    found = deviation_field(lifted, F, "Target", V, F)
    assert found.values == pytest.approx([0.5, 2])
    with pytest.raises(native.InvalidInput, match="names vertex"):
        native.distances(V, V, F + 2)
    with pytest.raises(native.InvalidInput, match="not finite"):
        native.distances(V * np.nan, V, F)


def test_a_field_that_can_not_be_had_has_no_values():
    V, F = np.zeros((3, 3)), np.array([[0, 1, 2]], np.int32)
    one = deviation_field(V, F, "Target", V, np.empty((0, 3), np.int32))
    assert one.values.shape == (1,) and np.isnan(one.values).all()
    assert not len(one.problems) and not len(one.order) and one.automatic_range() == (0, 1)
