# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds contacts that are open in a scan.

The plane that a tile's scanned points lie on says how the tile has tilted. Where two tiles have tilted
against one another, the walls between them gape at one end, by the change of the angle times their height.
Tiles that moved apart without tilting are not seen: a scan of the front does not show the walls.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ..base.native import native

LEAST = 6    # points of a tile
OPEN = 0.1   # mm that walls gape
CERTAIN = 3  # standard deviations by which an opening exceeds nothing
TILTED = 0.2  # of the tiles' edges: farther off a tile no point of it lies
FAR = 4.0    # times the typical distance from a tile's plane, beyond which a point is an outlier


def openings(design: Any, shapes: Any, points: np.ndarray, owners: np.ndarray, signed: np.ndarray
             ) -> dict[str, Any]:
    """For compare.json. shapes: native TileShapes; points: registered; owners: the row of F that each is on;
    signed: its deviation there, mm."""
    V, F = np.asarray(design.V), np.asarray(design.F)
    near = abs(signed) <= TILTED * native.mean_edge_length(V, F)
    left = _tilts(V[F], points[near], owners[near], signed[near])[2]
    near[near] = abs(left) <= FAR * 1.4826 * np.nanmedian(abs(left)) + 1e-9
    tilt, covariance, _ = _tilts(V[F], points[near], owners[near], signed[near])
    pairs, sides = np.asarray(shapes.contacts), np.asarray(shapes.contact_sides)
    across = [_across(V[F[tiles]], edges) for tiles, edges in zip(pairs.T, sides.T)]  # out of each tile
    turn = sum(np.einsum("kc,kc->k", out, tilt[tiles]) for out, tiles in zip(across, pairs.T))
    error = np.sqrt(sum(np.einsum("ka,kab,kb->k", out, covariance[tiles], out)
                        for out, tiles in zip(across, pairs.T)))
    gape, error = abs(turn) * design.parameters.get("H_body"), error * design.parameters.get("H_body")
    seen = np.isfinite(gape) & (CERTAIN * error <= OPEN)
    found = seen & (gape > OPEN + CERTAIN * error)
    return {"limit_mm": OPEN, "contacts_seen": int(seen.sum()), "contacts": len(pairs),
            "largest_mm": float(gape[seen].max(initial=0.0)), "open": pairs[found].tolist()}


def _tilts(corners: np.ndarray, points: np.ndarray, owners: np.ndarray, signed: np.ndarray
           ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The slope of the deviation over each tile (n x 3, in its plane), its covariance, and what is left of
    the deviation of each point; NaN where there are too few points."""
    along, normal = corners[:, 1] - corners[:, 0], np.cross(corners[:, 1] - corners[:, 0],
                                                            corners[:, 2] - corners[:, 0])
    u, w = (rows / np.linalg.norm(rows, axis=1)[:, None] for rows in (along, normal))
    frame = np.stack([u, np.cross(w, u)], axis=1)  # n x 2 x 3
    flat = np.einsum("pac,pc->pa", frame[owners], points - corners.mean(1)[owners])
    rows = np.concatenate([np.ones((len(flat), 1)), flat], axis=1)
    count, size = np.bincount(owners, minlength=len(corners)), len(corners)
    matrix, right, square = np.zeros((size, 3, 3)), np.zeros((size, 3)), np.zeros(size)
    np.add.at(matrix, owners, rows[:, :, None] * rows[:, None])
    np.add.at(right, owners, rows * signed[:, None])
    enough = (count >= LEAST) & (np.linalg.cond(matrix) < 1e9)
    solved, inverse = np.full((size, 3), np.nan), np.full((size, 3, 3), np.nan)
    inverse[enough] = np.linalg.inv(matrix[enough])
    solved[enough] = np.einsum("nab,nb->na", inverse[enough], right[enough])
    left = signed - np.einsum("pa,pa->p", rows, solved[owners])
    np.add.at(square, owners, left ** 2)
    variance = (square / np.maximum(count - 3, 1))[:, None, None]
    return (np.einsum("na,nac->nc", solved[:, 1:], frame),
            np.einsum("nac,nab,nbd->ncd", frame, variance * inverse[:, 1:, 1:], frame), left)


def _across(corners: np.ndarray, edges: np.ndarray) -> np.ndarray:
    """Directions out of tiles across one edge each, in their planes."""
    rows = np.arange(len(edges))
    start, end, left = (corners[rows, (edges + k) % 3] for k in range(3))
    along = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
    inwards = left - start
    out = np.einsum("kc,kc->k", inwards, along)[:, None] * along - inwards
    return np.asarray(out / np.linalg.norm(out, axis=1)[:, None])
