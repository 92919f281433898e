# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tiles and pins for drawing: prisms with corners 0 to 2 in front, 3 to 5 behind them.

Front and back of a tile are three triangles about their middle, one at each edge: the value of a contact
colours the third of both tiles beside it. Each tile has six slots of colour: front at edge 0, 1, 2, which
the walls share, and back at edge 0, 1, 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SLOTS = 6


@dataclass(frozen=True)
class Topology:
    """Polygons of one prism (counter-clockwise from outside), and numbers of their normals and colours.
    `points`, `colours`: counts for a prism; with 0 colours all prisms share one."""

    points: int
    colours: int
    polygons: tuple[tuple[int, ...], ...]
    normal: tuple[int, ...]
    colour: tuple[int, ...]

    def coordinate_index(self, count: int) -> np.ndarray:
        """Polygons of `count` prisms as Coin reads them."""
        return _index(self.polygons, self.points, count)

    def normal_index(self, count: int) -> np.ndarray:
        return (np.array(self.normal) + 5 * np.arange(count)[:, None]).astype(np.int32).ravel()

    def colour_index(self, count: int) -> np.ndarray:
        return (np.array(self.colour) + self.colours * np.arange(count)[:, None]).astype(np.int32).ravel()


_WALLS = ((1, 0, 3, 4), (2, 1, 4, 5), (0, 2, 5, 3))
THIRDS = Topology(8, SLOTS, ((0, 1, 6), (1, 2, 6), (2, 0, 6), (4, 3, 7), (5, 4, 7), (3, 5, 7), *_WALLS),
                  (0, 0, 0, 1, 1, 1, 2, 3, 4), (0, 1, 2, 3, 4, 5, 0, 1, 2))
WHOLE = Topology(6, 0, ((0, 1, 2), (5, 4, 3), *_WALLS), (0, 1, 2, 3, 4), (0,) * 5)

_RIMS = ((0, 1, 2, 0, 3, 4, 5, 3), (1, 4), (2, 5))  # polylines along all edges of a prism


def line_index(count: int) -> np.ndarray:
    """Edges of `count` prisms of six points as Coin reads them."""
    return _index(_RIMS, 6, count)


def _index(parts: tuple[tuple[int, ...], ...], points: int, count: int) -> np.ndarray:
    """Corners of `parts` in each of `count` prisms; -1 ends a part."""
    flat = np.array([corner for part in parts for corner in (*part, -1)])
    return np.where(flat < 0, -1, flat + points * np.arange(count)[:, None]).astype(np.int32).ravel()


def normals(corners: np.ndarray) -> np.ndarray:
    """Outward normals (M x 5 x 3) of front, back and the walls at edges 0 to 2. Zero for a face without area:
    Coin wants numbers."""
    a, b, c, d, e, f = (corners[:, k] for k in range(6))
    across = np.stack([np.cross(b - a, c - a), np.cross(f - d, e - d), np.cross(a - b, e - b),
                       np.cross(b - c, f - c), np.cross(c - a, d - a)], axis=1)
    length = np.linalg.norm(across, axis=2, keepdims=True)
    return across / np.where(length > 0, length, 1)


def with_middles(corners: np.ndarray) -> np.ndarray:
    """Points of THIRDS, M x 8 x 3: corners, and the middles of front and back."""
    return np.concatenate([corners, corners[:, :3].mean(1, keepdims=True),
                           corners[:, 3:].mean(1, keepdims=True)], axis=1)


def pin_prisms(pins: np.ndarray) -> np.ndarray:
    """Prisms (2M x 6 x 3) of pins (M x 2 x 6 x 3: front and back, three corners of the base and three of the
    top). Their fronts point the way of the tile's front."""
    front, back = pins[:, 0], pins[:, 1]
    return np.concatenate([np.concatenate([front[:, 3:], front[:, :3]], axis=1), back])
