# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves tiles from the flat layout into the target shape, each as a rigid body.

A tile's motion is a motion of the whole, the same for all tiles, and what is left over for it. Both go
from nothing to all as t goes from 0 to 1: rotations about a fixed axis (slerp), centres on a straight
line. Taking the whole's motion out first keeps tiles from tumbling where the target stands elsewhere or
is turned against the layout.
"""

from __future__ import annotations

import numpy as np


def frames(corners: np.ndarray) -> np.ndarray:
    """M x 3 x 3 rotations whose columns are a triangle's first edge, what is square to it in the plane,
    and the normal. `corners`: M x 3 x 3, one corner a row, not on one line."""
    along = corners[:, 1] - corners[:, 0]
    normal = np.cross(along, corners[:, 2] - corners[:, 0])
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    normal = normal / np.linalg.norm(normal, axis=1, keepdims=True)
    return np.stack([along, np.cross(normal, along), normal], axis=2)


def quaternions(rotations: np.ndarray) -> np.ndarray:
    """M x 4 unit quaternions (w, x, y, z), w at least 0, of M x 3 x 3 rotations."""
    r = rotations
    outer = np.empty((len(r), 4, 4))  # four times the quaternion's products with itself
    trace = r[:, 0, 0] + r[:, 1, 1] + r[:, 2, 2]
    outer[:, 0, 0] = 1 + trace
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        outer[:, i + 1, i + 1] = 1 + 2 * r[:, i, i] - trace
        outer[:, 0, i + 1] = outer[:, i + 1, 0] = r[:, k, j] - r[:, j, k]
        outer[:, i + 1, j + 1] = outer[:, j + 1, i + 1] = r[:, i, j] + r[:, j, i]
    # Any row is a multiple of the quaternion; the longest has the most digits.
    largest = np.argmax(np.einsum("mii->mi", outer), axis=1)
    found = outer[np.arange(len(r)), largest]
    found = found / np.linalg.norm(found, axis=1, keepdims=True)
    return np.where(found[:, :1] < 0, -found, found)


def part_of(turns: np.ndarray, t: float) -> np.ndarray:
    """M x 3 x 3 rotations by the share t of the angles of quaternions (M x 4)."""
    sine = np.linalg.norm(turns[:, 1:], axis=1)
    half = t * np.arctan2(sine, turns[:, 0])
    safe = np.where(sine > 0, sine, 1)
    w, (x, y, z) = np.cos(half), (turns[:, 1:] * (np.sin(half) / safe)[:, None]).T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                     2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                     2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
                    axis=1).reshape(-1, 3, 3)


class Motion:
    """The way of M tiles. `flat`, `actuated`: their front corners, M x 3 x 3 in mm."""

    def __init__(self, flat: np.ndarray, actuated: np.ndarray):
        self._from, to = flat.mean(1), actuated.mean(1)
        own = frames(actuated) @ frames(flat).transpose(0, 2, 1)
        area = np.linalg.norm(np.cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]), axis=1)
        u, _, vt = np.linalg.svd(np.einsum("m,mij->ij", area, own))
        whole = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt  # the rotation nearest to all of them
        self._middle = np.average(self._from, axis=0, weights=area)
        self._shift = np.average(to, axis=0, weights=area) - self._middle
        self._whole = quaternions(whole[None])
        self._own = quaternions(whole.T @ own)
        self._step = (to - self._middle - self._shift) @ whole + self._middle - self._from

    def middle(self, t: float) -> np.ndarray:
        """Where the middle of all tiles is, mm."""
        return self._middle + t * self._shift

    def move(self, points: np.ndarray, t: float) -> np.ndarray:
        """Where points on the tiles (M x K x 3, mm, in the flat layout) are at t."""
        whole = part_of(self._whole, t)[0]
        turned = (points - self._from[:, None]) @ part_of(self._own, t).transpose(0, 2, 1)
        gathered = turned + (self._from + t * self._step - self._middle)[:, None]
        return gathered @ whole.T + self.middle(t)

    def blend(self, flat: np.ndarray, actuated: np.ndarray, t: float) -> np.ndarray:
        """The same for what bends on the way: points (K x 3, mm) of which both places are known."""
        inverse = (actuated - self.middle(1)) @ part_of(self._whole, 1)[0] + self._middle
        return (flat + t * (inverse - flat) - self._middle) @ part_of(self._whole, t)[0].T + self.middle(t)
