# SPDX-License-Identifier: LGPL-2.1-or-later
"""The former: a body on which the finished shell lies, and by which its shape is checked without a scanner.

It can be pushed in along the mean normal of the back. Where the shell overhangs, as seen from there, it stops
at the nearest part of the shell.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Mapping, Sequence

import numpy as np

from ..base.native import native

FOOT = 10.0         # mm below the lowest point
GAP = 6.0           # mm between formers of several pieces
STEP = 1.0          # mm between samples of the shape
MOST_STEPS = 400
LEAST_AREA = 100.0  # mm2 of a part


@dataclass(frozen=True)
class Former:
    """heights: mm over the ground, by steps along u and v; NaN where nothing is above. step: mm."""

    heights: np.ndarray
    step: float

    @classmethod
    def of(cls, design: Any, parameters: Any, area: Mapping[str, float]) -> list[Former]:
        """Formers below the pieces of an actuated design, as high as the membrane on its pins. area: block of
        report.json."""
        get, V, F = parameters.get, np.asarray(design.V), np.asarray(design.F)
        thin = area["flat_cm2"] / (get("tau") ** 2 * area["actuated_cm2"])
        back, front = (get("H_pin") + thin * get(f"thickness_{side}") for side in ("back", "front"))
        piece = np.asarray(native.pieces_of_faces(V, F, design.cuts))
        return [cls.below(V, F[piece == number], get("H_body") + back, front)
                for number in range(int(piece.max(initial=0)) + 1)]

    @classmethod
    def below(cls, V: np.ndarray, F: np.ndarray, depth: float, rise: float = 0.0) -> Former:
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

        covered = np.isfinite(self.heights)
        parts, _ = label(covered[:-1, :-1] & covered[1:, :-1] & covered[:-1, 1:] & covered[1:, 1:])
        counts = np.bincount(parts.ravel())[1:]
        large = counts >= min(LEAST_AREA / self.step**2, counts.max(initial=0))
        kept = np.concatenate([[False], large])[parts]
        while True:
            a, b, c, d = kept[:-1, :-1], kept[1:, :-1], kept[:-1, 1:], kept[1:, 1:]
            crossed = (a & d & ~b & ~c) | (b & c & ~a & ~d)
            if not crossed.any():
                return np.asarray(kept)
            kept[:-1, :-1] &= ~crossed
            kept[1:, :-1] &= ~crossed

    def facets(self) -> np.ndarray:
        """Corners of the body's triangles, n x 3 x 3."""
        cells = self.cells
        i, j = np.nonzero(cells)
        corners = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
        at = np.stack([i, j], 1)[:, None] + corners  # cells x 4 x 2
        top = np.concatenate([at * self.step, self.heights[at[..., 0], at[..., 1]][..., None]], axis=-1)
        ground = np.concatenate([top[:, :, :2], np.zeros((*top.shape[:2], 1))], axis=2)
        quads = [top, ground[:, ::-1]]
        wide = np.pad(cells, 1)
        for side, (di, dj) in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)]):
            rim = ~wide[i + 1 + di, j + 1 + dj]
            a, b = side, (side + 1) % 4
            quads.append(np.stack([ground[rim, a], ground[rim, b], top[rim, b], top[rim, a]], axis=1))
        return np.concatenate([quad[:, pick] for quad in quads for pick in ([0, 1, 2], [0, 2, 3])])

    @property
    def size(self) -> tuple[float, float]:
        """Extent along u and v, mm."""
        u, v = self.heights.shape
        return (u - 1) * self.step, (v - 1) * self.step

    @property
    def volume(self) -> float:
        """Volume of the body, cm3."""
        top = self.heights
        means = (top[:-1, :-1] + top[1:, :-1] + top[:-1, 1:] + top[1:, 1:]) / 4
        return float(means[self.cells].sum() * self.step**2 / 1000)


def former_stl(formers: Sequence[Former]) -> bytes:
    """Closed bodies side by side, one a piece, as binary STL."""
    places = np.cumsum([0.0, *(former.size[0] + GAP for former in formers)])
    corners = np.concatenate([former.facets() + (x, 0, 0) for former, x in zip(formers, places)])
    rows = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    rows["corners"] = corners
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rows["normal"] = normals / np.linalg.norm(normals, axis=1)[:, None]
    return b"CurveUps former".ljust(80) + np.uint32(len(rows)).tobytes() + rows.tobytes()


def figures(formers: Sequence[Former]) -> dict[str, float]:
    """Block of kit.json."""
    return {"step_mm": max(former.step for former in formers),
            "height_mm": max(float(np.nanmax(former.heights)) for former in formers),
            "volume_cm3": sum(former.volume for former in formers)}


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
