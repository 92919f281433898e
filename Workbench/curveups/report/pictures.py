# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a design: flat layout and actuated view, drawn by matplotlib without a display.

The same design gives the same bytes: no dates, no random ids, fixed sizes.
"""

from __future__ import annotations

import io
from typing import Any

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "curveups"
matplotlib.rcParams["font.size"] = 9

import numpy as np  # noqa: E402
from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

BODY, PIN, EDGE, CUT, SMALL = "#e9c98f", "#b5651d", "#7a5a2b", "#c0392b", "#d81b60"


def inset_triangles(corners: np.ndarray, q: np.ndarray) -> np.ndarray:
    """M x 3 x 2 triangles whose edges lie q (M x 3) inside those of `corners`."""
    edge = np.roll(corners, -1, axis=1) - corners
    unit = edge / np.linalg.norm(edge, axis=2, keepdims=True)
    inward = np.stack([-unit[..., 1], unit[..., 0]], axis=2)
    offset = np.einsum("mtk,mtk->mt", inward, corners) + q
    # Corner t lies on the moved edges t - 1 and t.
    n0, n1 = np.roll(inward, 1, axis=1), inward
    c0, c1 = np.roll(offset, 1, axis=1), offset
    det = n0[..., 0] * n1[..., 1] - n0[..., 1] * n1[..., 0]
    x = (c0 * n1[..., 1] - c1 * n0[..., 1]) / det
    y = (n0[..., 0] * c1 - n1[..., 0] * c0) / det
    return np.stack([x, y], axis=2)


def flat_layout(design: Any, values: np.ndarray | None = None, label: str = "",
                width: float = 9.0) -> bytes:
    """Tiles with their front pins, to scale; `values` colours the tiles."""
    T, q = np.asarray(design.T), np.asarray(design.q)
    low, high = T.reshape(-1, 2).min(0), T.reshape(-1, 2).max(0)
    span = np.maximum(high - low, 1e-9)
    figure = Figure(figsize=(width, float(np.clip(width * span[1] / span[0], 3, 14))))
    axes = figure.add_axes([0.06, 0.05, 0.92, 0.92])
    thin = float(np.clip(120 / np.sqrt(len(T)) / 10, 0.15, 0.8))
    tiles = PolyCollection(T, edgecolors=EDGE, linewidths=thin)
    if values is None:
        tiles.set_facecolor(BODY)
    else:
        tiles.set_array(values)
        tiles.set_cmap("viridis")
        figure.colorbar(tiles, ax=axes, shrink=0.6, label=label)
    axes.add_collection(tiles)
    axes.add_collection(PolyCollection(inset_triangles(T, q[:, 0]), facecolors=PIN,
                                       edgecolors="none", alpha=0.85 if values is None else 0.25))
    margin = 0.02 * span.max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.set_xlabel("mm")
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    return _png(figure)


def actuated_view(design: Any, width: float = 7.0) -> bytes:
    """The tiles in the target shape, lit, seen from the front's side at an angle."""
    V, F = np.asarray(design.V), np.asarray(design.F)
    camera = _camera(V, F)
    points = (V - V.mean(0)) @ camera.T
    corners = points[F]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    front = normal[:, 2] > 0
    light = np.array([-0.35, 0.5, 0.8])
    light /= np.linalg.norm(light)
    shade = 0.3 + 0.7 * np.abs(normal @ light)
    colour = np.where(front[:, None], matplotlib.colors.to_rgb("#f0b24a"),
                      matplotlib.colors.to_rgb("#8fa7bf")) * shade[:, None]
    order = np.argsort(corners[:, :, 2].mean(1), kind="stable")  # painter: far ones first
    low, high = points[:, :2].min(0), points[:, :2].max(0)
    span = np.maximum(high - low, 1e-9)
    figure = Figure(figsize=(width, float(np.clip(width * span[1] / span[0], 2.5, 9))))
    axes = figure.add_axes([0, 0, 1, 1])
    axes.add_collection(PolyCollection(corners[order][:, :, :2], facecolors=colour[order].clip(0, 1),
                                       edgecolors="#5b4420", linewidths=0.25))
    margin = 0.04 * span.max()
    axes.set_xlim(low[0] - margin, high[0] + margin)
    axes.set_ylim(low[1] - margin, high[1] + margin)
    axes.set_aspect("equal")
    axes.axis("off")
    return _png(figure)


def _camera(V: np.ndarray, F: np.ndarray) -> np.ndarray:
    """Rows: right, up and towards the eye; from above the mean normal, 35 degrees off it."""
    a, b, c = V[F[:, 0]], V[F[:, 1]], V[F[:, 2]]
    towards = np.cross(b - a, c - a).sum(0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
    if np.linalg.norm(towards) < 0.05 * area:  # all around, as a sphere
        towards = np.array([0.3, -1.0, 0.4])
    towards = towards / np.linalg.norm(towards)
    aside = np.array([0.25, -0.9, 0.1]) if abs(towards[2]) > 0.7 else np.array([0.3, 0.2, 0.9])
    aside = aside - aside @ towards * towards
    aside /= np.linalg.norm(aside)
    eye = np.cos(np.radians(50)) * towards + np.sin(np.radians(50)) * aside
    up = np.array([0.0, 0.0, 1.0])
    if abs(eye @ up) > 0.97:
        up = np.array([0.0, 1.0, 0.0])
    right = np.cross(up, eye)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(eye, right), eye])


def _png(figure: Figure) -> bytes:
    buffer = io.BytesIO()
    FigureCanvasAgg(figure)
    figure.savefig(buffer, format="png", dpi=130, metadata={"Software": None})
    return buffer.getvalue()
