# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lays scanned points onto a surface without a start.

Many turns, spread over all there are, begin at once with the middles on one another. Each is drawn to the
surface by iterated closest points on few of the scan's points; these rounds take the surface's tangent planes
from a table. Tiles are alike from one to the next, and a scan with a part missing slides over a smooth shape:
so turns around the best follow, less than a tile apart, and the best of these go on with more points. Some
points lie off in every scan: those beyond a share of a tile, and in the end those far beyond the typical
distance, don't count.

A turn whose distances are not larger than the best's by more than their noise, but which takes tiles to other
tiles, is another answer: nothing but the shape fixes the turn, so a symmetric shape has several.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Protocol

import numpy as np

from ..base.motions import rigid_motion
from ..base.native import native

FEW, MORE, MANY, MOST = 150, 600, 3000, 20000  # points of a scan that the rounds take, one after the other
CELLS = 40            # of the table, along the surface's longest side
NEAR, NEARER = 0.25, 0.1  # of a tile: points beyond that don't count, at first and then
FAR = 3.0             # times the typical distance, beyond which a point does not count in the end
WORST = 4.0           # times the best's loss, with which a pose goes on
ROUNDS = 30           # of markers
AROUND = 40           # turns around each of the best
ARRIVED = 0.01, 1e-4  # mm that a step moves a pose no more, in the search and in the end
ALIKE = 3.0           # standard deviations by which sums of the same noise differ

Planes = tuple[np.ndarray, np.ndarray]  # unit directions away from the surface (.. x 3) and distances


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


class Surface(Protocol):
    def away(self, points: np.ndarray) -> Planes:
        """Of points (.. x 3); distances of a table may be negative."""


@dataclass(frozen=True)
class Exact:
    V: np.ndarray
    F: np.ndarray

    def away(self, points: np.ndarray) -> Planes:
        arm = points - native.closest_points(points.reshape(-1, 3), self.V, self.F).reshape(points.shape)
        distance = np.linalg.norm(arm, axis=-1)
        return arm / np.maximum(distance, 1e-12)[..., None], distance


class Table:
    """The planes on which the nearest points of a grid's cells lie, around the surface's box."""

    def __init__(self, surface: Exact):
        low, high = surface.V.min(0), surface.V.max(0)
        self._size = float((high - low).max()) / CELLS
        self._low = low - 0.25 * (high - low).max()
        self._counts = np.ceil((high - low + 0.5 * (high - low).max()) / self._size).astype(int)
        middles = self._low + (np.indices(self._counts).reshape(3, -1).T + 0.5) * self._size
        out, distance = surface.away(middles)
        self._planes = np.c_[out, (out * middles).sum(1) - distance]

    def away(self, points: np.ndarray) -> Planes:
        cell = np.clip(((points - self._low) / self._size).astype(int), 0, self._counts - 1)
        planes = self._planes[np.ravel_multi_index(tuple(np.moveaxis(cell, -1, 0)), tuple(self._counts))]
        return planes[..., :3], np.einsum("...i,...i", points, planes[..., :3]) - planes[..., 3]


@dataclass(frozen=True)
class Poses:
    """R: n x 3 x 3, t: n x 3."""

    R: np.ndarray
    t: np.ndarray

    def __getitem__(self, rows: Any) -> Poses:
        return Poses(self.R[rows], self.t[rows])

    def __call__(self, points: np.ndarray) -> np.ndarray:
        """Poses x points x 3."""
        return np.asarray(points @ self.R.transpose(0, 2, 1) + self.t[:, None])


def register(points: np.ndarray, V: np.ndarray, F: np.ndarray, tile: float,
             go_on: Callable[[float], object] = lambda done: None) -> Registration:
    """points: n x 3, V, F: the surface. tile: mm of the surface within which turns are the same. go_on:
    called with the share that is done; may raise."""
    order = np.random.default_rng(0).permutation(len(points))
    few, more, many, most = (points[order[:count]] for count in (FEW, MORE, MANY, MOST))
    go_on(0.0)
    exact, turns = Exact(V, F), _turns()
    poses = Poses(turns, _middle(V, F) - turns @ np.median(points, axis=0))
    poses = _kept(few, poses, Table(exact), 8, 60, NEAR * tile, lambda: go_on(0.1))
    poses = _around(few, poses, tile)
    for sample, rounds, kept, share in ((few, 2, 300, 0.3), (few, 4, 100, 0.6), (more, 4, 40, 0.7),
                                        (more, 8, 12, 0.8), (many, 20, 12, 0.9)):
        poses = _kept(sample, poses, exact, rounds, kept, NEARER * tile, lambda: go_on(share))
    distance = abs(exact.away(poses(many))[1])
    losses = np.minimum(distance, FAR * _typical(distance).min()) ** 2
    best = int(losses.mean(1).argmin())
    worse = losses - losses[best]
    alike = worse.mean(1) <= ALIKE * worse.std(1) / np.sqrt(len(many))
    last = _drawn(most, poses[best:best + 1], exact, 15, 0.0, ARRIVED[1], lambda: go_on(0.95))
    spread = np.sort(exact.away(last(many))[1][0])[:max(1, int(0.7 * len(many)))]
    go_on(1.0)
    return Registration(last.R[0], last.t[0], float(np.sqrt((spread ** 2).mean())),
                        _distinct(V, poses[alike], poses[best], tile) - 1)


def register_markers(points: np.ndarray, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """R, t of x -> R x + t that takes points to their places, n x 3; those far off count less and less, as
    where two markers were taken for one another."""
    weight = np.ones(len(points))
    for _ in range(ROUNDS):
        R, t = rigid_motion(points, places, weight)
        distance = np.linalg.norm(points @ R.T + t - places, axis=1)
        weight = _weights(distance, FAR * _typical(distance))
    return R, t


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


def _middle(V: np.ndarray, F: np.ndarray) -> np.ndarray:
    corners = V[F]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return np.asarray((corners.mean(1) * area[:, None]).sum(0) / area.sum())


def _kept(points: np.ndarray, poses: Poses, surface: Surface, rounds: int, count: int, limit: float,
          go_on: Callable[[], object]) -> Poses:
    """The best of poses after so many steps, apart from one another, the best first."""
    poses = _drawn(points, poses, surface, rounds, limit, ARRIVED[0], go_on)
    loss = (np.minimum(abs(surface.away(poses(points))[1]), limit) ** 2).mean(1)
    places, found = poses(_ends(points)), [int(loss.argmin())]
    for one in np.argsort(loss, kind="stable"):
        if loss[one] > WORST * loss[found[0]] + 1e-9 or len(found) == count:
            break
        if np.linalg.norm(places[found] - places[one], axis=2).max(1).min() > limit:
            found.append(int(one))
    return poses[found]


def _around(points: np.ndarray, poses: Poses, tile: float) -> Poses:
    """Each pose, and others that are turned by a tile's size at most."""
    noise = np.random.default_rng(1)
    vectors = noise.normal(size=(AROUND, 3))
    vectors *= (noise.random(AROUND) ** (1 / 3) / np.linalg.norm(vectors, axis=1))[:, None]
    vectors[0] = 0
    turn = _rotations(vectors * min(0.25, 2 * tile / np.ptp(points, axis=0).max()))
    middle = np.median(points, axis=0)
    R = np.einsum("nij,pjk->pnik", turn, poses.R).reshape(-1, 3, 3)
    return Poses(R, np.repeat(poses(middle[None])[:, 0], AROUND, axis=0) - R @ middle)


def _ends(points: np.ndarray) -> np.ndarray:
    """Six points around all others, by which poses differ."""
    reach = 0.5 * np.ptp(points, axis=0).max()
    return np.asarray(points.mean(0) + reach * np.vstack([np.eye(3), -np.eye(3)]))


def _drawn(points: np.ndarray, poses: Poses, surface: Surface, rounds: int, limit: float,
           arrived: float, go_on: Callable[[], object]) -> Poses:
    """Poses after so many steps; those that a step moves by less than `arrived` rest. limit: mm within which
    points count."""
    found, moving, ends = Poses(poses.R.copy(), poses.t.copy()), np.arange(len(poses.t)), _ends(points)
    for _ in range(rounds):
        go_on()
        before = found[moving]
        after = _step(points, before, surface, limit)
        found.R[moving], found.t[moving] = after.R, after.t
        moving = moving[np.linalg.norm(after(ends) - before(ends), axis=2).max(1) > arrived]
        if not len(moving):
            break
    return found


def _step(points: np.ndarray, poses: Poses, surface: Surface, least: float) -> Poses:
    """One step of every pose: towards the surface across it, and freely along it. least: mm within which
    points count."""
    moved = poses(points)
    out, distance = surface.away(moved)
    weight = _weights(distance, np.maximum(FAR * _typical(distance), least)[:, None])
    middle = (weight[..., None] * moved).sum(1) / weight.sum(1)[:, None]
    arm = moved - middle[:, None]
    rows = np.concatenate([np.cross(arm, out), out], axis=2)
    weighted = (rows * weight[..., None]).transpose(0, 2, 1)
    normal = weighted @ rows
    scale = np.einsum("pii->p", normal)[:, None, None] / 6
    size = np.sqrt((arm ** 2).sum(2).mean(1))[:, None, None]
    damp = np.diag([1.0] * 3 + [0.0] * 3) * size ** 2 + np.diag([0.0] * 3 + [1.0] * 3)
    normal = normal + 1e-6 * scale / size ** 2 * damp + 1e-12 * np.eye(6)
    twist = -np.linalg.solve(normal, weighted @ distance[..., None])[..., 0]
    angle = np.linalg.norm(twist[:, :3], axis=1)
    twist *= np.minimum(1.0, 0.5 / np.maximum(angle, 1e-12))[:, None]  # half a radian at most
    turn = _rotations(twist[:, :3])
    return Poses(turn @ poses.R, np.einsum("pij,pj->pi", turn, poses.t - middle) + middle + twist[:, 3:])


def _weights(distance: np.ndarray, limit: np.ndarray) -> np.ndarray:
    """Tukey's."""
    return np.asarray(np.where(abs(distance) < limit, (1 - (distance / limit) ** 2) ** 2, 0.0))


def _typical(distance: np.ndarray) -> np.ndarray:
    """Standard deviation of most of a row."""
    return np.asarray(1.4826 * np.median(abs(distance), axis=-1) + 1e-9)


def _rotations(vectors: np.ndarray) -> np.ndarray:
    """By rotation vectors, n x 3 (Rodrigues)."""
    angle = np.linalg.norm(vectors, axis=1)[:, None, None]
    x, y, z = (vectors / np.maximum(angle[:, 0], 1e-300)).T
    cross = np.zeros((len(vectors), 3, 3))
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -z, y, -x
    cross = cross - cross.transpose(0, 2, 1)
    return np.asarray(np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)


def _distinct(V: np.ndarray, poses: Poses, best: Poses, tile: float) -> int:
    """How many poses take the surface's vertices to places that are farther apart than a tile's half."""
    base = (V - best.t) @ best.R  # the scan's places of vertices
    found = [V]
    for places in poses(base):
        if all(np.linalg.norm(places - other, axis=1).max() > tile / 2 for other in found):
            found.append(places)
    return len(found)
