# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies below the finished shell: ribs and a former on which it comes into shape and is checked, without
a scanner.

They can be pushed in along the mean normal of the back. Where the shell overhangs, as seen from there, they
stop at what is nearest.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Iterator, Mapping, Sequence

import numpy as np

from ..base.native import native

SHEET = 3.0      # mm, thickness of the ribs' material
CLEARANCE = 0.1  # mm that slots are wider
FOOT = 10.0      # mm of ribs and former below the lowest point
SPACING = 30.0   # mm between ribs, about
TWO = 24.0       # mm of a piece with two ribs in a direction
MOST_RIBS = 12   # in a direction
STEP = 1.0       # mm between samples of the shape
MOST_STEPS = 400
LEAST_RIB = 8.0  # mm
LEAST_AREA = 100.0  # mm2 of a part of the former


@dataclass(frozen=True)
class Underside:
    """heights: mm over the ground, by steps along u and v; NaN where nothing is above. step: mm."""

    heights: np.ndarray
    step: float

    @classmethod
    def of(cls, design: Any, parameters: Any, area: Mapping[str, float]) -> list[Underside]:
        """Below the membranes as they lie on the pins, of each piece of an actuated design. area: of
        report.json."""
        get, V, F = parameters.get, np.asarray(design.V), np.asarray(design.F)
        thin = area["flat_cm2"] / (get("tau") ** 2 * area["actuated_cm2"])
        back, front = (get("H_pin") + thin * get(f"thickness_{side}") for side in ("back", "front"))
        piece = np.asarray(native.pieces_of_faces(V, F, design.cuts))
        return [cls.below(V, F[piece == number], get("H_body") + back, front)
                for number in range(int(piece.max(initial=0)) + 1)]

    @classmethod
    def below(cls, V: np.ndarray, F: np.ndarray, depth: float, rise: float = 0.0) -> Underside:
        """V: N x 3, F: M x 3, counter-clockwise seen from the front; depth, rise: mm from there to the back
        and to the front, which is below where the shell turns under itself."""
        used, F = np.unique(F, return_inverse=True)
        V, F = V[used], F.reshape(-1, 3)
        normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
        sums = np.zeros_like(V)
        for corner in range(3):
            np.add.at(sums, F[:, corner], normals)
        units = sums / np.maximum(np.linalg.norm(sums, axis=1), 1e-12)[:, None]
        faces = normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
        bent = np.einsum("nck,nk->n", units[F], faces) / 3  # a vertex moves further than its faces
        cosine = np.ones(len(V))
        np.minimum.at(cosine, F, np.broadcast_to(bent[:, None], F.shape))
        out = units / np.maximum(cosine, 0.5)[:, None]
        frame = _frame(normals)
        down = normals @ frame[2] < 0
        placed = np.concatenate([(V - depth * out)[F], (V + rise * out)[F[down]]]) @ frame.T
        low, high = placed.min((0, 1)), placed.max((0, 1))
        step = max(STEP, float((high - low)[:2].max()) / MOST_STEPS)
        placed = placed - [*low[:2], low[2] - FOOT]
        heights = np.full(tuple((np.floor((high - low)[:2] / step) + 1).astype(int)), np.nan)
        for triangle in placed:
            _lower(heights, triangle, step)
        return cls(heights, step)

    @cached_property
    def cells(self) -> np.ndarray:
        """Squares between samples that have the shell above all corners; none touch by a corner alone, and
        none are slivers but for the largest part."""
        from scipy.ndimage import label  # which other commands would pay

        there = np.isfinite(self.heights)
        parts, _ = label(there[:-1, :-1] & there[1:, :-1] & there[:-1, 1:] & there[1:, 1:])
        counts = np.bincount(parts.ravel())[1:]
        large = counts >= min(LEAST_AREA / self.step**2, counts.max(initial=0))
        found = np.concatenate([[False], large])[parts]
        while True:
            a, b, c, d = found[:-1, :-1], found[1:, :-1], found[:-1, 1:], found[1:, 1:]
            crossed = (a & d & ~b & ~c) | (b & c & ~a & ~d)
            if not crossed.any():
                return np.asarray(found)
            found[:-1, :-1] &= ~crossed
            found[1:, :-1] &= ~crossed

    def facets(self) -> np.ndarray:
        """Of what is below, down to the ground: corners, n x 3 x 3."""
        cells = self.cells
        i, j = np.nonzero(cells)
        corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
        at = np.stack([i, j], 1)[:, None] + corners  # cells x 4 x 2
        top = self._points(at)
        ground = np.concatenate([top[:, :, :2], np.zeros((*top.shape[:2], 1))], axis=2)
        quads = [top, ground[:, ::-1]]
        wide = np.pad(cells, 1)
        for side, (di, dj) in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
            rim = ~wide[i + 1 + di, j + 1 + dj]
            a, b = side, (side + 1) % 4
            quads.append(np.stack([ground[rim, a], ground[rim, b], top[rim, b], top[rim, a]], axis=1))
        return np.concatenate([quad[:, pick] for quad in quads for pick in ([0, 1, 2], [0, 2, 3])])

    def _points(self, at: np.ndarray) -> np.ndarray:
        return np.concatenate([at * self.step, self.heights[at[..., 0], at[..., 1]][..., None]], axis=-1)

    @property
    def size(self) -> tuple[float, float]:
        """mm along u and v."""
        u, v = self.heights.shape
        return (u - 1) * self.step, (v - 1) * self.step

    @property
    def volume(self) -> float:
        """Of the body, cm3."""
        top = self.heights
        means = (top[:-1, :-1] + top[1:, :-1] + top[:-1, 1:] + top[1:, 1:]) / 4
        return float(means[self.cells].sum() * self.step**2 / 1000)

    @cached_property
    def ribs(self) -> list[Rib]:
        """Those along u, then those along v; each meets one of the others. Where two would meet too close to
        an end, that end goes, and what it met with it: slots follow when all ends are known."""
        found = [[*self._ribs(axis)] for axis in (0, 1)]
        while any([a.yields(b) or b.yields(a) for a in found[0] for b in found[1]]):
            found = [[rib for rib in ribs if rib.length > LEAST_RIB] for ribs in found]
        for a in found[0]:
            for b in found[1]:
                a.meet(b)
        return [rib for rib in (*found[0], *found[1]) if rib.slots]

    def _ribs(self, axis: int) -> Iterator[Rib]:
        heights = self.heights if axis == 0 else self.heights.T
        size = heights.shape[1]
        count = int(np.clip(round(size * self.step / SPACING), 1 + (size * self.step > TWO), MOST_RIBS))
        half = int(np.ceil(SHEET / 2 / self.step))
        for number in range(count):
            place = int((number + 0.75) / (count + 0.5) * size)
            band = heights[:, max(0, place - half):place + half + 1]
            there = np.isfinite(band).all(axis=1)
            ends = np.flatnonzero(np.diff(np.pad(there, 1).astype(int)))
            for part, (begin, end) in enumerate(ends.reshape(-1, 2)):
                name = f"{'UV'[axis]}{number + 1}{'abcdefgh'[part % 8] if len(ends) > 2 else ''}"
                x = np.arange(begin, end) * self.step
                yield Rib(name, axis, place * self.step, x, band[begin:end].min(axis=1))


@dataclass
class Rib:
    """An upright plate. axis: 0 along u, 1 along v; place: mm on the other axis; x, top: its upper edge, mm.
    slots: where others cross it, and their height there."""

    name: str
    axis: int
    place: float
    x: np.ndarray
    top: np.ndarray
    slots: list[tuple[float, float]] = field(default_factory=list)

    @property
    def length(self) -> float:
        return float(self.x[-1] - self.x[0]) if len(self.x) > 1 else 0.0

    def meets(self, other: Rib) -> bool:
        return self._spans(other.place) and other._spans(self.place)

    def yields(self, other: Rib) -> bool:
        """Whether it gave up an end, at which it would have met the other."""
        place = other.place
        if not self.meets(other) or min(place - self.x[0], self.x[-1] - place) >= SHEET + 1:
            return False
        keep = self.x < place - SHEET if place > self.x.mean() else self.x > place + SHEET
        self.x, self.top = self.x[keep], self.top[keep]
        return True

    def meet(self, other: Rib) -> None:
        """Slots for a rib of the other direction, half as deep as the lower one is high."""
        if self.meets(other):
            height = min(self._lowest(other.place), other._lowest(self.place))
            self.slots.append((other.place, height))
            other.slots.append((self.place, height))

    def _spans(self, place: float) -> bool:
        return len(self.x) > 1 and self.x[0] - SHEET < place < self.x[-1] + SHEET

    def _lowest(self, place: float) -> float:
        """Beside a slot, too: the edge may be steep there."""
        return float(self.top[abs(self.x - place) <= SHEET + self.x[1] - self.x[0]].min())

    def _height(self, place: float) -> float:
        return float(np.interp(place, self.x, self.top))

    def foot(self) -> tuple[float, float]:
        """The widest part of the lower edge without a slot, mm along the rib."""
        places = [place for place, _ in self.slots] if self.axis == 1 else []
        half = (SHEET + CLEARANCE) / 2
        ends = [self.x[0], *(end for place in sorted(places) for end in (place - half, place + half)),
                self.x[-1]]
        return max(((float(a), float(b)) for a, b in zip(ends[::2], ends[1::2])),
                   key=lambda part: part[1] - part[0])

    def outline(self) -> np.ndarray:
        """A closed line, counter-clockwise from its lower left corner: N x 2, mm."""
        upper, lower = [*zip(self.x, self.top)], [(self.x[0], 0.0), (self.x[-1], 0.0)]
        half = (SHEET + CLEARANCE) / 2
        for place, height in self.slots:
            left, right = place - half, place + half
            if self.axis == 0:  # from above
                kept = [point for point in upper if not left <= point[0] <= right]
                upper = sorted([*kept, (left, self._height(left)), (right, self._height(right))])
        edge: list[tuple[float, float]] = []
        if self.axis == 0:
            middles = {place - half: height / 2 for place, height in self.slots}
            for point in upper:
                edge.append(point)
                if point[0] in middles:
                    edge += [(point[0], middles[point[0]]), (point[0] + 2 * half, middles[point[0]])]
        else:
            edge = upper
            below = [lower[0]]
            for place, height in sorted(self.slots):
                below += [(place - half, 0.0), (place - half, height / 2), (place + half, height / 2),
                          (place + half, 0.0)]
            lower = [*below, lower[1]]
        return np.array([*lower, *edge[::-1], lower[0]])


def _frame(normals: np.ndarray) -> np.ndarray:
    """Rows u, v and up: up is the mean normal of the front; z where the shape is closed."""
    mean = normals.sum(0)
    up = mean / np.linalg.norm(mean) if np.linalg.norm(mean) > 0.02 * np.linalg.norm(normals, axis=1).sum() \
        else np.array([0.0, 0.0, 1.0])
    aside = np.eye(3)[0 if abs(up[0]) < 0.9 else 1]
    v = np.cross(up, aside)
    v /= np.linalg.norm(v)
    return np.array([np.cross(v, up), v, up])


def _lower(heights: np.ndarray, triangle: np.ndarray, step: float) -> None:
    """Lowers samples below which the triangle is."""
    low = np.maximum(np.ceil(triangle[:, :2].min(0) / step - 1e-9), 0).astype(int)
    high = np.floor(triangle[:, :2].max(0) / step + 1e-9).astype(int) + 1
    a, b, c = triangle
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if (high <= low).any() or abs(area) < 1e-9:
        return
    part = heights[low[0]:high[0], low[1]:high[1]]
    x = np.arange(low[0], low[0] + part.shape[0])[:, None] * step
    y = np.arange(low[1], low[1] + part.shape[1])[None, :] * step
    s = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
    t = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
    z = a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2])
    inside = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
    part[inside] = np.fmin(part[inside], z[inside])


def named(undersides: Sequence[Underside]) -> list[tuple[str, Rib]]:
    """Ribs with their names: U and V by their directions, and first the piece where there are several."""
    return [(f"P{piece} {rib.name}" if len(undersides) > 1 else rib.name, rib)
            for piece, under in enumerate(undersides, 1) for rib in under.ribs]


def figures(undersides: Sequence[Underside]) -> dict[str, Any]:
    """For kit.json."""
    return {"ribs": [name for name, _ in named(undersides)], "sheet_mm": SHEET, "slot_mm": SHEET + CLEARANCE,
            "step_mm": max(under.step for under in undersides),
            "height_mm": max(float(np.nanmax(under.heights)) for under in undersides),
            "former_cm3": sum(under.volume for under in undersides)}
