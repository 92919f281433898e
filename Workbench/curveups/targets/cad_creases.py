# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds where faces of a CAD part meet in a sharp edge: exactly, however flat the edge and however coarse the
triangles. Shapes, faces and edges are FreeCAD's Part."""

from __future__ import annotations

import math
from typing import Any, Iterator, Sequence

import numpy as np

_NEAR = 1e-5         # of the part's size: triangles' vertices on an edge are this near to it
_PLACES = 5          # of an edge at which normals are compared


def shared_edges(faces: Sequence[Any]) -> Iterator[tuple[Any, int, int]]:
    """Edges that two of the faces have in common, with the numbers of both."""
    known: dict[int, list[tuple[Any, int]]] = {}
    for number, face in enumerate(faces):
        for edge in face.Edges:
            known.setdefault(edge.hashCode(), []).append((edge, number))
    for places in known.values():
        while places:
            edge, first = places.pop()
            for k, (other, second) in enumerate(places):
                if edge.isSame(other):
                    places.pop(k)
                    if first != second:
                        yield edge, first, second
                    break


def creases(faces: Sequence[Any], V: np.ndarray, angle: float) -> np.ndarray:
    """Sharp sides of the triangulation of faces with vertices V (N x 3), as pairs of vertices (E x 2). They
    lie on edges along which the normals of both faces differ by more than `angle` (degrees) somewhere."""
    pairs: list[tuple[int, int]] = []
    if angle < 180:
        tolerance = _NEAR * float(np.linalg.norm(np.ptp(V, axis=0)))
        for edge, first, second in shared_edges(faces):
            if _turn(edge, faces[first], faces[second]) > angle:
                along = _vertices_on(edge, V, tolerance)
                pairs += zip(along, along[1:])
    return np.array(pairs, np.int32).reshape(-1, 2)


def _turn(edge: Any, first: Any, second: Any) -> float:
    """The largest angle between the normals of two faces along their edge, degrees; 0 where there is none."""
    angles = [math.degrees(math.atan2(a.cross(b).Length, a.dot(b)))
              for a, b in normals_along(edge, first, second, _PLACES)]
    return max(filter(math.isfinite, angles), default=0.0)


def normals_along(edge: Any, first: Any, second: Any, places: int) -> Iterator[tuple[Any, Any]]:
    """The normals of two faces at places that are spread evenly along their edge, but for its ends."""
    for t in np.linspace(edge.FirstParameter, edge.LastParameter, places + 2)[1:-1]:
        try:
            point = edge.valueAt(float(t))
            a, b = (face.normalAt(*face.Surface.parameter(point)) for face in (first, second))
        except Exception:  # a degenerate edge, or a tip; FreeCAD raises its own types
            continue
        yield a, b


def _vertices_on(edge: Any, V: np.ndarray, tolerance: float) -> list[int]:
    """Rows of V on an edge, in their order along it; of a closed one the first again at its end."""
    try:
        line = np.array([tuple(point) for point in edge.discretize(Deflection=tolerance / 2)])
    except Exception:  # an edge without length
        return []
    if len(line) < 2:
        return []
    side = np.diff(line, axis=0)
    length = np.linalg.norm(side, axis=1)
    before = np.concatenate([[0.0], np.cumsum(length)])
    places: list[tuple[float, int]] = []
    in_box = (V >= line.min(axis=0) - tolerance) & (V <= line.max(axis=0) + tolerance)
    for v in np.flatnonzero(in_box.all(axis=1)).tolist():
        away = V[v] - line[:-1]
        t = np.clip((away * side).sum(1) / np.maximum(length, 1e-300) ** 2, 0, 1)
        distance = np.linalg.norm(away - t[:, None] * side, axis=1)
        k = int(np.argmin(distance))
        if distance[k] <= tolerance:
            places.append((float(before[k] + t[k] * length[k]), v))
    along = [v for _, v in sorted(places)]
    closed = np.linalg.norm(line[0] - line[-1]) <= tolerance
    return [*along, along[0]] if closed and len(along) > 2 else along
