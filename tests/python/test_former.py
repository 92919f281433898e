# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formers below shapes of all kinds: they are closed, and stay below the shell."""

import numpy as np
import pytest

from curveups.base import freecad_session
from curveups.kit.former import FOOT, Former, figures, former_stl
from made import sheet

THICK = (4.1, 1.1)  # mm, behind and before the front


def hemisphere(radius, rings=40, around=120):
    turn = np.linspace(0, 2 * np.pi, around, endpoint=False)
    V = [(0, 0, radius)]
    for angle in np.linspace(0, np.pi / 2, rings + 1)[1:]:
        V += list(zip(radius * np.sin(angle) * np.cos(turn), radius * np.sin(angle) * np.sin(turn),
                      np.full(around, radius * np.cos(angle))))
    F = [(0, 1 + i, 1 + (i + 1) % around) for i in range(around)]
    for start in range(1, 1 + (rings - 1) * around, around):
        for i in range(around):
            a, b = start + i, start + (i + 1) % around
            F += [(a, a + around, b + around), (a, b + around, b)]
    return np.array(V), np.array(F)


def test_a_former_fills_a_hemisphere():
    V, F = hemisphere(48)
    former = Former.below(V, F, 4.1)
    inner = 43.9
    i, j = np.indices(former.heights.shape)
    away = np.hypot(i - inner, j - inner)
    there = away < 40
    wanted = 10 + np.sqrt(inner**2 - away[there]**2)
    assert np.abs(former.heights[there] - wanted).max() < 0.15


def ball(radius, rings):
    """Closed, counter-clockwise from outside."""
    V, F = hemisphere(radius, rings, 4 * rings)
    return np.concatenate([V, V * (1, 1, -1)]), np.concatenate([F, F[:, ::-1] + len(V)])


def torus(large=50.0, small=18.0, around=48, across=24):
    u, v = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * u / around, 2 * np.pi * v / across
    ring = large + small * np.cos(b)
    V = np.stack([ring * np.cos(a), ring * np.sin(a), small * np.sin(b)], axis=2).reshape(-1, 3)
    right, up = (u + 1) % around, (v + 1) % across
    corners = [(one * across + other).ravel() for one, other in ((u, v), (right, v), (right, up), (u, up))]
    return V, np.concatenate([np.stack([corners[k] for k in pick], 1) for pick in ((0, 1, 2), (0, 2, 3))])


SHAPES = {"saddle": sheet(lambda x, y: (x**2 - y**2) / 60, 50, 23), "plate": sheet(lambda x, y: 0, 50, 23),
          "cliff": sheet(lambda x, y: 40 * np.tanh(x - y), 50, 23), "ball": ball(40, 12),
          "small ball": ball(9, 3), "few tiles": hemisphere(9, 2, 6), "torus": torus(),
          "strip": sheet(lambda x, y: x**2 / 90, 20, 7)}


@pytest.mark.parametrize("shape", SHAPES)
def test_a_former_is_one_closed_body_below_the_shell(shape, tmp_path):
    V, F = SHAPES[shape]
    former = Former.below(V, F, *THICK)
    (tmp_path / "former.stl").write_bytes(former_stl([former]))
    _, mesh = freecad_session.load("Mesh")
    found = mesh.Mesh(str(tmp_path / "former.stl"))
    assert found.isSolid() and not found.hasNonManifolds() and found.countComponents() == 1
    assert found.Volume == pytest.approx(1000 * former.volume, rel=5e-3)


def test_a_closed_shape_is_cradled_from_outside():
    former = Former.below(*SHAPES["ball"], *THICK)
    radius = 41.1
    assert np.nanmin(former.heights) == pytest.approx(FOOT, abs=0.05)
    i, j = np.indices(former.heights.shape) - np.array(former.heights.shape)[:, None, None] // 2
    near = np.hypot(i, j) < 30
    wanted = FOOT + radius - np.sqrt(radius**2 - np.hypot(i, j)[near]**2)
    assert np.abs(former.heights[near] - wanted).max() < 0.7  # facets and half a sample


def test_each_piece_has_a_former_of_its_own():
    V, F = hemisphere(30, 10, 40)
    V = np.concatenate([V, V + (0, 0, 80)])
    formers = [Former.below(V, F + offset, *THICK) for offset in (0, len(V) // 2)]
    assert formers[0].volume == pytest.approx(formers[1].volume, rel=1e-3)  # though one lies below the other
    assert figures(formers)["volume_cm3"] == pytest.approx(2 * formers[0].volume, rel=1e-3)
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    corners = np.frombuffer(former_stl(formers)[84:], facet)["corners"]
    left, right = corners[:len(corners) // 2], corners[len(corners) // 2:]
    assert left[..., 0].max() + 5 < right[..., 0].min()
