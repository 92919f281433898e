# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ribs and formers below shapes of all kinds: they are closed, can be put together, and stay below the
shell."""


import numpy as np
import pytest

from curveups.kit.former import former_stl
from curveups.kit.underside import FOOT, LEAST_RIB, SHEET, Underside, figures, named
from running import by_admesh

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


def test_ribs_and_former_fill_a_hemisphere_and_can_be_put_together():
    V, F = hemisphere(48)
    under = Underside.below(V, F, 4.1)
    inner = 43.9
    i, j = np.indices(under.heights.shape)
    away = np.hypot(i - inner, j - inner)
    there = away < 40
    wanted = 10 + np.sqrt(inner**2 - away[there]**2)
    assert np.abs(under.heights[there] - wanted).max() < 0.15
    assert len(under.ribs) == 6
    for rib in under.ribs:
        assert rib.slots, rib.name
        # Both faces of the sheet stay below the sphere, and one nearly touches it.
        across = abs(rib.place - inner) + np.array([1.5, 2.0])[:, None]
        touching, lower = 10 + np.sqrt(np.maximum(0, inner**2 - across**2 - (rib.x - inner)**2))
        assert (rib.top - touching).max() < 0.1 and (lower - rib.top).max() < 0.1, rib.name
        for place, height in rib.slots:
            others = [one for one in under.ribs if one.axis != rib.axis and abs(one.place - place) < 1e-9]
            assert any((rib.place, height) in one.slots for one in others)
        left, right = rib.foot()  # where its name stands
        assert right - left > 10 and rib.x[0] <= left < right <= rib.x[-1]
        assert rib.axis == 0 or not any(left - 1.5 < place < right + 1.5 for place, _ in rib.slots)
        outline = rib.outline()
        x, y = outline[:-1].T
        area = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
        cut = sum(height / 2 if rib.axis else np.interp(place, rib.x, rib.top) - height / 2
                  for place, height in rib.slots) * 3.1
        assert area == pytest.approx(np.trapezoid(rib.top, rib.x) - cut if hasattr(np, "trapezoid")
                                     else np.trapz(rib.top, rib.x) - cut, rel=2e-3)


def grid(height, size=50.0, count=24):
    """A height field, seen from the front above it."""
    x, y = np.meshgrid(*[np.linspace(-size, size, count)] * 2, indexing="ij")
    i, j = np.meshgrid(*[np.arange(count - 1)] * 2, indexing="ij")
    a = (i * count + j).ravel()
    return (np.stack([x, y, height(x, y)], axis=2).reshape(-1, 3),
            np.concatenate([np.stack([a, a + count, a + count + 1], 1),
                            np.stack([a, a + count + 1, a + 1], 1)]))


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


SHAPES = {"saddle": grid(lambda x, y: (x**2 - y**2) / 60), "plate": grid(lambda x, y: 0 * x),
          "cliff": grid(lambda x, y: 40 * np.tanh(x - y)), "ball": ball(40, 12), "small ball": ball(9, 3),
          "few tiles": hemisphere(9, 2, 6), "torus": torus(), "strip": grid(lambda x, y: x**2 / 90, 20, 8)}


def crossings(line):
    """How often a closed line crosses itself."""
    a, b = line[:-1], line[1:]

    def side(p, q, r):
        return np.sign((q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1])
                       - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0]))

    pairs = np.array([(i, j) for i in range(len(a)) for j in range(i)]).T
    (p, q), (r, s) = ((a[one], b[one]) for one in pairs)
    return np.count_nonzero((side(p, q, r) * side(p, q, s) < 0) & (side(r, s, p) * side(r, s, q) < 0))


@pytest.mark.parametrize("shape", SHAPES)
def test_every_slot_lies_inside_of_its_rib_and_has_its_partner(shape):
    under = Underside.below(*SHAPES[shape], *THICK)
    assert len(under.ribs) >= 2 or shape == "few tiles"  # 10 mm wide: the former alone
    for rib in under.ribs:
        assert rib.slots and rib.length > LEAST_RIB
        places = np.array(sorted(place for place, _ in rib.slots))
        assert places[0] - rib.x[0] > SHEET and rib.x[-1] - places[-1] > SHEET
        assert (np.diff(places) > 3 * SHEET).all() and crossings(rib.outline()) == 0
        for place, height in rib.slots:
            beside = rib.top[abs(rib.x - place) < SHEET / 2 + 0.05]
            assert FOOT - 1e-9 <= height <= beside.min() + 1e-9
            assert any(one.axis != rib.axis and one.place == place and (rib.place, height) in one.slots
                       for one in under.ribs)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_former_is_one_closed_body_below_the_shell(shape, tmp_path):
    V, F = SHAPES[shape]
    under = Underside.below(V, F, *THICK)
    (tmp_path / "former.stl").write_bytes(former_stl([under]))
    found = by_admesh(tmp_path / "former.stl")
    assert found["Total disconnected facets"] == found["Backwards edges"] == 0
    assert found["Number of parts"] == 1 and found["Volume"] == pytest.approx(1000 * under.volume, rel=5e-3)


def test_a_closed_shape_is_cradled_from_outside():
    under = Underside.below(*SHAPES["ball"], *THICK)
    radius = 41.1
    assert np.nanmin(under.heights) == pytest.approx(FOOT, abs=0.05)
    i, j = np.indices(under.heights.shape) - np.array(under.heights.shape)[:, None, None] // 2
    near = np.hypot(i, j) < 30
    wanted = FOOT + radius - np.sqrt(radius**2 - np.hypot(i, j)[near]**2)
    assert np.abs(under.heights[near] - wanted).max() < 0.7  # facets and half a sample


def test_each_piece_has_ribs_and_a_former_of_its_own():
    V, F = hemisphere(30, 10, 40)
    V = np.concatenate([V, V + (0, 0, 80)])
    unders = [Underside.below(V, F + offset, *THICK) for offset in (0, len(V) // 2)]
    assert unders[0].volume == pytest.approx(unders[1].volume, rel=1e-3)  # though one lies below the other
    names = [name for name, _ in named(unders)]
    assert len(set(names)) == len(names) and {name.split()[0] for name in names} == {"P1", "P2"}
    assert figures(unders)["former_cm3"] == pytest.approx(2 * unders[0].volume, rel=1e-3)
    facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    corners = np.frombuffer(former_stl(unders)[84:], facet)["corners"]
    left, right = corners[:len(corners) // 2], corners[len(corners) // 2:]
    assert left[..., 0].max() + 5 < right[..., 0].min()
