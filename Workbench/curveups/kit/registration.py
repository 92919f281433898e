# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lays scanned points onto a surface without a start.

Many turns, spread over all there are, begin at once with the middles on one another. Each is drawn to the
surface by iterated closest points on few of the scan's points, and the best go on with more. Then the best
turns about the axis around which it slides most easily, since tiles there are alike from one to the next.
Some points lie off in every scan: those far beyond the typical distance don't count.

A turn that fits as well as the best but takes tiles to other tiles is another answer: nothing but the shape
fixes the turn, so a symmetric shape has several.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from ..base.native import native

FEW, MORE, MANY, MOST = 150, 600, 3000, 20000  # points of a scan that the rounds take, one after the other
FAR = 3.0             # times the typical distance, beyond which a point does not count
SLIDES = 240          # turns about the easiest axis
ALIKE = 3.0           # standard deviations by which distances of the same noise differ


@dataclass(frozen=True)
class Registration:
    """x -> R x + t takes a point of the scan to the surface. spread: typical distance there, mm. others: how
    many other turns, at least, fit as well."""

    R: np.ndarray
    t: np.ndarray
    spread: float
    others: int

    def __call__(self, points: np.ndarray) -> np.ndarray:
        return points @ self.R.T + self.t


def register(points: np.ndarray, V: np.ndarray, F: np.ndarray, tile: float,
             go_on: Callable[[float], object] = lambda done: None) -> Registration:
    """points: n x 3, V, F: the surface. tile: mm of the surface within which turns are the same. go_on:
    called with the share that is done; may raise."""
    order = np.random.default_rng(0).permutation(len(points))
    few, more, many = (points[order[:count]] for count in (FEW, MORE, MANY))
    R = _turns()
    t = _middles(V, F) - (R @ np.median(points, axis=0))
    for sample, rounds, kept, share in ((few, 12, 60, 0.3), (more, 12, 1, 0.4), (more, 15, 12, 0.8),
                                        (many, 20, 12, 0.9)):
        if len(R) == 1:
            R, t = _slides(more, R[0], t[0], V, F)
        for _ in range(rounds):
            R, t = _step(sample, R, t, V, F)
            go_on(share)
        R, t = (one[_order(sample, R, t, V, F)[:kept]] for one in (R, t))
    spread = _spreads(many, R, t, V, F)
    alike = spread <= spread[0] * (1 + ALIKE * np.sqrt(1.5 / len(many)))
    for _ in range(15):
        R[:1], t[:1] = _step(points[order[:MOST]], R[:1], t[:1], V, F)
    go_on(1.0)
    others = _distinct(V, R[alike], t[alike], R[0], t[0], tile) - 1
    return Registration(R[0], t[0], float(_spreads(many, R[:1], t[:1], V, F)[0]), others)


def _turns() -> np.ndarray:
    """Rotations some 25 degrees apart."""
    count, around = 60, 15
    z = 1 - (2 * np.arange(count) + 1) / count
    angle = np.pi * (1 + 5 ** 0.5) * np.arange(count)
    axis = np.stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z], axis=1)
    side = np.cross(axis, np.where(abs(axis[:, :1]) < 0.5, [1.0, 0, 0], [0, 1.0, 0]))
    side = side / np.linalg.norm(side, axis=1)[:, None]
    frame = np.stack([side, np.cross(axis, side), axis], axis=2)
    spin = 2 * np.pi * np.arange(around) / around
    turns = np.array([[[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]] for a in spin])
    return np.einsum("nij,mjk->nmik", frame, turns).reshape(-1, 3, 3)


def _middles(V: np.ndarray, F: np.ndarray) -> np.ndarray:
    corners = V[F]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return np.asarray((corners.mean(1) * area[:, None]).sum(0) / area.sum())


def _away(points: np.ndarray, R: np.ndarray, t: np.ndarray, V: np.ndarray, F: np.ndarray
          ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Moved points and their nearest ones on the surface, poses x n x 3, and the distances."""
    moved = np.einsum("pij,nj->pni", R, points) + t[:, None]
    near = native.closest_points(moved.reshape(-1, 3), V, F).reshape(moved.shape)
    return moved, near, np.linalg.norm(moved - near, axis=2)


def _step(points: np.ndarray, R: np.ndarray, t: np.ndarray, V: np.ndarray, F: np.ndarray
          ) -> tuple[np.ndarray, np.ndarray]:
    """One step of every pose: towards the surface across it, and freely along it."""
    moved, near, distance = _away(points, R, t, V, F)
    limit = FAR * 1.4826 * np.median(distance, axis=1)[:, None] + 1e-9
    weight = np.where(distance < limit, (1 - (distance / limit) ** 2) ** 2, 0.0)
    out = (moved - near) / np.maximum(distance, 1e-12)[..., None]
    middle = (weight[..., None] * moved).sum(1) / weight.sum(1)[:, None]
    arm = moved - middle[:, None]
    rows = np.concatenate([np.cross(arm, out), out], axis=2)
    normal = np.einsum("pni,pnj,pn->pij", rows, rows, weight)
    scale = np.einsum("pii->p", normal)[:, None, None] / 6
    size = np.sqrt((arm ** 2).sum(2).mean(1))[:, None, None]
    damp = np.diag([1.0] * 3 + [0.0] * 3) * size ** 2 + np.diag([0.0] * 3 + [1.0] * 3)
    normal = normal + 1e-6 * scale / size ** 2 * damp + 1e-12 * np.eye(6)
    twist = -np.linalg.solve(normal, np.einsum("pni,pn,pn->pi", rows, distance, weight)[..., None])[..., 0]
    angle = np.linalg.norm(twist[:, :3], axis=1)
    twist *= np.minimum(1.0, 0.5 / np.maximum(angle, 1e-12))[:, None]  # half a radian at most
    turn = _rotations(twist[:, :3])
    return turn @ R, np.einsum("pij,pj->pi", turn, t - middle) + middle + twist[:, 3:]


def _rotations(vectors: np.ndarray) -> np.ndarray:
    """By rotation vectors, n x 3 (Rodrigues)."""
    angle = np.linalg.norm(vectors, axis=1)[:, None, None]
    x, y, z = (vectors / np.maximum(angle[:, 0], 1e-300)).T
    cross = np.zeros((len(vectors), 3, 3))
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -z, y, -x
    cross = cross - cross.transpose(0, 2, 1)
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def _spreads(points: np.ndarray, R: np.ndarray, t: np.ndarray, V: np.ndarray, F: np.ndarray) -> np.ndarray:
    """Typical distance of each pose: the root of the mean of squares of the nearer 70 %."""
    distance = np.sort(_away(points, R, t, V, F)[2], axis=1)[:, : max(1, int(0.7 * len(points)))]
    return np.asarray(np.sqrt((distance ** 2).mean(1)))


def _order(points: np.ndarray, R: np.ndarray, t: np.ndarray, V: np.ndarray, F: np.ndarray) -> np.ndarray:
    return np.argsort(_spreads(points, R, t, V, F), kind="stable")


def _slides(points: np.ndarray, R: np.ndarray, t: np.ndarray, V: np.ndarray, F: np.ndarray
            ) -> tuple[np.ndarray, np.ndarray]:
    """The pose, and poses all around in the direction in which distances change least."""
    moved, near, distance = (one[0] for one in _away(points, R[None], t[None], V, F))
    corners = V[F[native.closest_faces(moved, V, F)]]
    out = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    out = out / np.maximum(np.linalg.norm(out, axis=1), 1e-300)[:, None]
    out = out[distance < FAR * 1.4826 * np.median(distance) + 1e-9]
    moved = moved[distance < FAR * 1.4826 * np.median(distance) + 1e-9]
    middle = moved.mean(0)
    size = np.sqrt(((moved - middle) ** 2).sum(1).mean())
    rows = np.concatenate([np.cross(moved - middle, out) / size, out], axis=1)
    twist = np.linalg.eigh(rows.T @ rows)[1][:, 0] * ([1 / size] * 3 + [1] * 3)
    turning = np.linalg.norm(twist[:3])
    if turning * size < 1e-3:  # it slides straight
        return R[None], t[None]
    axis = twist[:3] / turning
    pivot = middle + np.cross(axis, twist[3:]) / turning
    turn = _rotations(axis * (2 * np.pi * np.arange(SLIDES) / SLIDES)[:, None])
    return turn @ R, np.einsum("pij,j->pi", turn, t - pivot) + pivot


def _distinct(V: np.ndarray, R: np.ndarray, t: np.ndarray, best_R: np.ndarray, best_t: np.ndarray,
              tile: float) -> int:
    """How many poses take the surface's vertices to places that are farther apart than a tile's half."""
    base = (V - best_t) @ best_R  # the scan's places of vertices
    found = [V]
    for one_R, one_t in zip(R, t):
        places = base @ one_R.T + one_t
        if all(np.linalg.norm(places - other, axis=1).max() > tile / 2 for other in found):
            found.append(places)
    return len(found)
