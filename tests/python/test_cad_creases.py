# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges that CAD marks as sharp stay edges of the tiling."""

import math

import cad
import numpy as np
import pytest
from curveups.targets.cad_files import read_cad
from curveups.targets.cad_parts import Choice
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages.cut_request import CutRequest
from curveups.stages.surface import find_source

L = 7.0


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    return cad.make(tmp_path_factory.mktemp("parts"), "folded", "sharp_lid", "lid", "dished", ending="step")


def target_of(path, **values):
    parameters = native.Parameters()
    for name, value in {"L": L, **values}.items():
        parameters.set(name, value)
    given = {"source": find_source(str(path)), "cut request": CutRequest()}
    return Project("part", parameters, given, str(path)).run(("target",))["target"]


def away(points, V, F):
    """Distance of each point from the nearest tile edge, mm."""
    sides = np.unique(np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    a, b = V[sides[:, 0]], V[sides[:, 1]]
    nearest = np.full(len(points), np.inf)
    for k, point in enumerate(points):
        t = np.clip(((point - a) * (b - a)).sum(1) / ((b - a) ** 2).sum(1), 0, 1)
        nearest[k] = np.linalg.norm(point - a - t[:, None] * (b - a), axis=1).min()
    return nearest


def along(*corners):
    corners = np.array(corners, float)
    return np.concatenate([a + np.linspace(0, 1, 200)[:, None] * (b - a)
                           for a, b in zip(corners, corners[1:])])


def test_what_bends_and_by_how_much_is_known(parts):
    for angle, length in ((7.9, 100), (8.1, 50), (34.9, 50), (35.1, 0), (180, 0)):
        found = read_cad(parts["folded"], 0.01, choice=Choice(crease_angle=angle))
        ends = found.V[found.creases]
        assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum() == pytest.approx(length), angle
        assert angle != 34.9 or (ends[:, :, 0] > 59).all()
    # Fillets go over into the faces beside them.
    assert len(read_cad(parts["lid"], 0.02, choice=Choice(crease_angle=1)).creases) == 0


def test_tiles_fold_along_the_edges_of_a_folded_sheet(parts):
    """Both folds, the shallow one too, whose facets turn less than those of a rounding."""
    shallow = along((30, 0, 0), (30, 50, 0))
    bend = math.radians(8)
    x, z = 30 + 30 * math.cos(bend), 30 * math.sin(bend)
    sharp = along((x, 0, z), (x, 50, z))
    kept = target_of(parts["folded"], crease_angle=5)
    assert away(shallow, kept.V, kept.F).max() < 1e-4 and away(sharp, kept.V, kept.F).max() < 1e-4
    # What bends less than is asked for is remeshed as the rest is.
    some = target_of(parts["folded"], crease_angle=20)
    assert away(shallow, some.V, some.F).max() > 0.3 and away(sharp, some.V, some.F).max() < 1e-4
    assert kept.chord_error < 1e-3


def test_every_edge_of_a_box_lid_is_covered(parts):
    kept = target_of(parts["sharp_lid"], crease_angle=40)
    low, high = kept.V.min(0), kept.V.max(0)
    assert np.allclose([low, high], [[0, 0, 0], [80, 60, 20]], atol=1e-4)
    top = along((0, 0, 20), (80, 0, 20), (80, 60, 20), (0, 60, 20), (0, 0, 20))
    upright = np.concatenate([along((x, y, 0), (x, y, 20)) for x in (0, 80) for y in (0, 60)])
    assert away(top, kept.V, kept.F).max() < 1e-4 and away(upright, kept.V, kept.F).max() < 1e-4


def test_round_edges_are_followed(parts):
    """A dish: a flat disc and a cone around it meet in a circle, on which all its vertices lie."""
    kept = target_of(parts["dished"], crease_angle=10)
    angles = np.linspace(0, 2 * math.pi, 400)
    circle = np.stack([25 * np.cos(angles), 25 * np.sin(angles), 0 * angles], axis=1)
    chord_error = 25 - math.sqrt(25 ** 2 - (0.6 * L) ** 2)
    assert away(circle, kept.V, kept.F).max() < chord_error
    on = np.isclose(np.hypot(kept.V[:, 0], kept.V[:, 1]), 25, atol=0.02) & (abs(kept.V[:, 2]) < 1e-4)
    assert on.sum() == pytest.approx(2 * math.pi * 25 / L, abs=3)


def test_the_middle_of_a_wall_keeps_its_edges(parts):
    found = read_cad(parts["sharp_lid"], 0.02, choice=Choice("middle", crease_angle=40))
    ends = found.V[found.creases]
    top = ends[(abs(ends[:, :, 2] - 19) < 1e-3).all(axis=1)]
    assert np.linalg.norm(top[:, 1] - top[:, 0], axis=1).sum() == pytest.approx(2 * (78 + 58), rel=1e-3)


def test_without_a_crease_angle_nothing_changes(parts):
    one, other = target_of(parts["folded"]), target_of(parts["folded"], crease_angle=90)
    assert np.array_equal(one.V, other.V) and np.array_equal(one.F, other.F)
    assert len(one.creases) == 0
