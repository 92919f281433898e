# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles and pins for drawing: prisms with corners 0 to 2 in front, 3 to 5 behind them.

A tile's front and back are each drawn as three triangles about their middle, one an edge, so that what
belongs to a contact colours the third of both tiles that is next to it. Colours therefore come in
slots, six a tile: front at edge 0, 1, 2 (which the walls share), back at edge 0, 1, 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SLOTS = 6


@dataclass(frozen=True)
class Topology:
    """Polygons of one prism (counter-clockwise from outside), and for each the number of its normal
    (see `normals`) and of its colour. `points`, `colours`: how many a prism has; without colours of their own
    all prisms have one."""

    points: int
    colours: int
    polygons: tuple[tuple[int, ...], ...]
    normal: tuple[int, ...]
    colour: tuple[int, ...]

    def coordinate_index(self, count: int) -> np.ndarray:
        """Of `count` prisms, as Coin reads it: -1 ends a polygon."""
        flat = np.array([corner for polygon in self.polygons for corner in (*polygon, -1)])
        return np.where(flat < 0, -1, flat + self.points * np.arange(count)[:, None]).astype(np.int32).ravel()

    def normal_index(self, count: int) -> np.ndarray:
        return (np.array(self.normal) + 5 * np.arange(count)[:, None]).astype(np.int32).ravel()

    def colour_index(self, count: int) -> np.ndarray:
        return (np.array(self.colour) + self.colours * np.arange(count)[:, None]).astype(np.int32).ravel()


_WALLS = ((1, 0, 3, 4), (2, 1, 4, 5), (0, 2, 5, 3))
THIRDS = Topology(8, SLOTS, ((0, 1, 6), (1, 2, 6), (2, 0, 6), (4, 3, 7), (5, 4, 7), (3, 5, 7), *_WALLS),
                  (0, 0, 0, 1, 1, 1, 2, 3, 4), (0, 1, 2, 3, 4, 5, 0, 1, 2))
WHOLE = Topology(6, 0, ((0, 1, 2), (5, 4, 3), *_WALLS), (0, 1, 2, 3, 4), (0,) * 5)

# Both faces' rims and the corners between them, as polylines of one prism.
RIMS = ((0, 1, 2, 0, 3, 4, 5, 3), (1, 4), (2, 5))


def line_index(count: int) -> np.ndarray:
    """The rims of `count` prisms of six points."""
    flat = np.array([corner for line in RIMS for corner in (*line, -1)])
    return np.where(flat < 0, -1, flat + 6 * np.arange(count)[:, None]).astype(np.int32).ravel()


def normals(corners: np.ndarray) -> np.ndarray:
    """M x 5 x 3 outward normals of front, back and the walls at edges 0 to 2. Zero where a face has no
    area: Coin wants numbers."""
    a, b, c, d, e, f = (corners[:, k] for k in range(6))
    found = np.stack([np.cross(b - a, c - a), np.cross(f - d, e - d), np.cross(a - b, e - b),
                      np.cross(b - c, f - c), np.cross(c - a, d - a)], axis=1)
    length = np.linalg.norm(found, axis=2, keepdims=True)
    return found / np.where(length > 0, length, 1)


def with_middles(corners: np.ndarray) -> np.ndarray:
    """M x 8 x 3: the points of THIRDS."""
    return np.concatenate([corners, corners[:, :3].mean(1, keepdims=True),
                           corners[:, 3:].mean(1, keepdims=True)], axis=1)


def pin_prisms(pins: np.ndarray) -> np.ndarray:
    """2M x 6 x 3 prisms, in front what is nearer to the tile's front, of pins (M x 2 x 6 x 3: front and
    back, three corners of the base and three of the top)."""
    front, back = pins[:, 0], pins[:, 1]
    return np.concatenate([np.concatenate([front[:, 3:], front[:, :3]], axis=1), back])
