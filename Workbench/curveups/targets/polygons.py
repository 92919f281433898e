# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divides faces of more than three corners into triangles."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from ..base.native import native


def triangles_of(V: np.ndarray, polygons: Sequence[Sequence[int]]) -> np.ndarray:
    """M x 3: fans of the convex polygons; the others divided in their plane, where a fan would reach
    outside. Polygons that cross themselves there become fans: what is wrong with them is checked later.
    Corners are rows of V (N x 3), three or more of each polygon, which keep their order."""
    if all(len(polygon) == 3 for polygon in polygons):
        return np.array(polygons, np.int32).reshape(-1, 3)
    concave = _concave(V, polygons)
    triangles: list[tuple[int, int, int]] = []
    for number, corners in enumerate(polygons):
        divided = native.triangulate_polygon(V[list(corners)]) if number in concave else []
        triangles.extend((corners[a], corners[b], corners[c]) for a, b, c in divided)
        if not divided:
            triangles.extend((corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1))
    return np.array(triangles, np.int32).reshape(-1, 3)


@np.errstate(over="ignore", invalid="ignore")  # what overflows is too large for a target
def _concave(V: np.ndarray, polygons: Sequence[Sequence[int]]) -> set[int]:
    """Numbers of the polygons that turn against their normal somewhere."""
    sizes = np.array([len(polygon) for polygon in polygons])
    found: set[int] = set()
    for size in np.unique(sizes[sizes > 3]):
        numbers = np.nonzero(sizes == size)[0]
        corners = V[np.array([polygons[number] for number in numbers])]
        sides = np.roll(corners, -1, axis=1) - corners
        # Newell's normal, and the turn at every corner.
        normal = np.cross(corners - corners[:, :1], sides).sum(axis=1)
        turns = np.einsum("pcx,px->pc", np.cross(sides, np.roll(sides, -1, axis=1)), normal)
        least = -1e-9 * np.einsum("px,px->p", normal, normal)
        found.update(numbers[(turns < least[:, None]).any(axis=1)].tolist())
    return found
