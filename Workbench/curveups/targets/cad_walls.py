# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the two skins of a part with a wall: faces in pairs at a constant distance, and the rim that joins
them. Faces are those of FreeCAD's Part; distances are measured along normals from points of a triangulation,
so that any kind of surface will do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Optional, Sequence

import numpy as np

from .cad_creases import normals_along, shared_edges

_EVEN = 0.2          # by which a wall may be thinner or thicker than most of it, relative: lofts are
_OPPOSITE = -0.9     # of normals: the faces of a wall look away from one another
_FACE_SHARE = 0.7    # of a face's area that lies opposite a face at the wall's distance
_SKIN_SHARE = 0.55   # of all area that is skin: otherwise the part is no wall
_SLENDER = 4.0       # a skin's extent over its wall's thickness, at least
_JOINED = 0.55       # of a face's rim that goes over into a skin without an edge: it belongs to that
_SMOOTH = 0.98       # cosine of the angle between normals where there is no edge
_MOST_RAYS, _MOST_PAIRS, _MOST_TRIANGLES = 1000, 40_000_000, 400_000


@dataclass(frozen=True)
class Wall:
    """Numbers of a shape's faces, from 0; the outer skin is the larger one."""

    thickness: float  # mm
    outer: tuple[int, ...]
    inner: tuple[int, ...]
    rim: tuple[int, ...]


def find_wall(solid: Any) -> Optional[Wall]:
    """The wall of a solid; None where it is none, or has more than two skins."""
    faces = list(solid.Faces)
    if len(faces) < 2:
        return None
    samples = _Samples(faces, solid.BoundBox.DiagonalLength)
    if not len(samples.points):
        return None
    distance, hit = samples.opposite()
    known = np.isfinite(distance)
    if samples.area[known].sum() < _SKIN_SHARE * samples.area.sum():
        return None
    thickness = _weighted_median(distance[known], samples.area[known])
    even = known & (np.abs(np.where(known, distance, 0) - thickness) < _EVEN * thickness)
    total = np.bincount(samples.face, samples.area, len(faces))
    # Of a damaged file a face may have no triangles, and so no area.
    skin = np.bincount(samples.face[even], samples.area[even], len(faces)) > _FACE_SHARE * total
    area = float(total[skin].sum())
    if area < _SKIN_SHARE * total.sum() or np.sqrt(area / 2) < _SLENDER * thickness:
        return None
    meetings = list(_meetings(faces))
    side = _two_sides(skin, meetings, samples.face[even], hit[even], samples.area[even])
    if side is None:
        return None
    _spread(side, meetings)
    areas = [float(total[side == s].sum()) for s in (0, 1)]
    heights = [float(np.average(samples.points[own, 2], weights=samples.area[own]))
               for own in (side[samples.face] == s for s in (0, 1))]
    alike = abs(areas[0] - areas[1]) < 1e-3 * sum(areas)  # a plate: the upper one
    outer = int(heights[1] > heights[0] if alike else areas[1] > areas[0])

    def of(which: int) -> tuple[int, ...]:
        return tuple(int(face) for face in np.flatnonzero(side == which))

    return Wall(thickness, of(outer), of(1 - outer), of(-1))


class _Samples:
    """Middles of triangles on faces: point, outward normal, area, number of the face."""

    def __init__(self, faces: Sequence[Any], size: float):
        corners, numbers = [], []
        deflection = 2e-3 * size
        for number, face in enumerate(faces):
            points, triangles = face.tessellate(deflection)
            if not triangles:
                continue
            V = np.array([tuple(point) for point in points], float)
            corners.append(V[np.array(triangles, int)])
            numbers.append(np.full(len(triangles), number))
        self._corners = np.concatenate([np.zeros((0, 3, 3)), *corners])
        self._deflection = deflection
        cross = np.cross(self._corners[:, 1] - self._corners[:, 0], self._corners[:, 2] - self._corners[:, 0])
        norm = np.linalg.norm(cross, axis=1)
        sound = norm > 1e-12 * size * size
        self._corners, cross, norm = self._corners[sound], cross[sound], norm[sound]
        self.points = self._corners.mean(axis=1)
        self.normal = cross / norm[:, None]
        self.area = norm / 2
        self.face = np.concatenate([np.zeros(0, int), *numbers])[sound]

    def opposite(self) -> tuple[np.ndarray, np.ndarray]:
        """Distance of the first triangle from each sample inwards, NaN where it does not look away, and the
        number of its face. Of many samples only the largest of each face have a distance and an area."""
        count = len(self.points)
        distance, hit = np.full(count, np.nan), np.full(count, -1)
        if count > _MOST_TRIANGLES:
            return distance, hit
        chosen = self._chosen()
        for block in np.array_split(chosen, max(1, len(chosen) * count // 4_000_000)):
            lengths, which = self._cast(block)
            distance[block] = np.where((self.normal[which] * self.normal[block]).sum(1) < _OPPOSITE, lengths,
                                       np.nan)
            hit[block] = self.face[which]
        rest = np.setdiff1d(np.arange(count), chosen)
        self.area[rest] = 0.0
        return distance, hit

    def _chosen(self) -> np.ndarray:
        most = min(_MOST_RAYS, _MOST_PAIRS // len(self.points))
        if len(self.points) <= most:
            return np.arange(len(self.points))
        kept = []
        each = max(8, most // (int(self.face.max()) + 1))
        for number in np.unique(self.face):
            own = np.flatnonzero(self.face == number)
            if len(own) > each:
                own = own[np.linspace(0, len(own) - 1, each).astype(int)]
            kept.append(own)
        chosen = np.concatenate(kept)
        whole = np.bincount(self.face, self.area)
        part = np.bincount(self.face[chosen], self.area[chosen])
        self.area[chosen] *= (whole / part)[self.face[chosen]]
        return chosen

    def _cast(self, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Moeller and Trumbore 1997: nearest triangle along the rays, and how far it is."""
        origin, direction = self.points[rows], -self.normal[rows]
        a = self._corners[:, 0]
        e1, e2 = self._corners[:, 1] - a, self._corners[:, 2] - a
        n = np.cross(e1, e2)
        det = -(direction @ n.T)
        with np.errstate(divide="ignore", invalid="ignore"):
            away = origin[:, None] - a[None]
            t = np.einsum("rtk,tk->rt", away, n) / det
            moment = np.cross(away, direction[:, None])
            u = np.einsum("rtk,tk->rt", moment, e2) / det
            v = -np.einsum("rtk,tk->rt", moment, e1) / det
            good = (u >= -1e-6) & (v >= -1e-6) & (u + v <= 1 + 1e-6) & (t > 2 * self._deflection * 1e-2)
        t = np.where(good, t, np.inf)
        t[np.arange(len(rows)), rows] = np.inf
        which = t.argmin(axis=1)
        return t[np.arange(len(rows)), which], which


def _weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    order = np.argsort(values, kind="stable")
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, total[-1] / 2)])


def _meetings(faces: Sequence[Any]) -> Iterator[tuple[int, int, float, bool]]:
    """Edges between two faces: their numbers, the edge's length, whether the faces go over into one another
    without a bend."""
    for edge, first, second in shared_edges(faces):
        smooth = any(a.dot(b) > _SMOOTH for a, b in normals_along(edge, faces[first], faces[second], 1))
        yield first, second, float(edge.Length), smooth


def _two_sides(skin: np.ndarray, meetings: Sequence[tuple[int, int, float, bool]], face: np.ndarray,
               hit: np.ndarray, area: np.ndarray) -> Optional[np.ndarray]:
    """Number the skins of faces, 0 and 1, -1 for others: neighbours are of one skin, faces that lie opposite
    one another of different ones."""
    count = len(skin)
    opposite = np.zeros((count, count))
    np.add.at(opposite, (face, hit), area)
    opposite = opposite + opposite.T
    side = np.full(count, -1)
    beside: dict[int, list[int]] = {}
    for first, second, _, _ in meetings:
        if skin[first] and skin[second]:
            beside.setdefault(first, []).append(second)
            beside.setdefault(second, []).append(first)
    for start in np.flatnonzero(skin):
        if side[start] >= 0:
            continue
        side[start], pending = 0, [int(start)]
        while pending:
            here = pending.pop()
            next_to = [(other, side[here]) for other in beside.get(here, ())]
            # All but slivers of what a face lies opposite to.
            far = np.flatnonzero(skin & (opposite[here] > 0.05 * opposite[here].sum()))
            next_to += [(int(other), 1 - side[here]) for other in far]
            for other, its in next_to:
                if side[other] < 0:
                    side[other] = its
                    pending.append(other)
                elif side[other] != its:
                    return None
    return side if {0, 1} <= set(side.tolist()) else None


def _spread(side: np.ndarray, meetings: Sequence[tuple[int, int, float, bool]]) -> None:
    """Faces of uneven thickness (a rounding outside of a sharp corner) go to the skin that they continue."""
    around = np.zeros(len(side))
    for first, second, length, _ in meetings:
        around[first] += length
        around[second] += length
    while True:
        joined = np.zeros((len(side), 2))
        for first, second, length, smooth in meetings:
            for face, other in ((first, second), (second, first)):
                if smooth and side[face] < 0 <= side[other]:
                    joined[face, side[other]] += length
        best = joined.argmax(axis=1)
        grown = np.flatnonzero(joined.max(axis=1) > _JOINED * np.maximum(around, 1e-12))
        if not len(grown):
            return
        side[grown] = best[grown]
