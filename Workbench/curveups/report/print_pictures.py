# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws all that is printed, from above, with its dimensions."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ..base.language import ENGLISH, Language
from ..base.native import native
from ..stages.solids import fits
from . import pictures

KINDS = ("support", "anchors", "tiles")
LINE = "#6d6454"
BAND = 1.3  # mm


def print_view(models: Sequence[Any], bed: Sequence[float], width: float = 9.0, say: Language = ENGLISH
               ) -> bytes:
    """models: native PrintModels, one a bed. bed: x and y, mm."""
    x, y, _ = (float(side) for side in models[0].bbox)
    height = width if models[1:] else float(np.clip(width * (y + 60) / (x + 30), 3, 14))
    figure = Figure(figsize=(width, height))
    draw_prints(figure.add_axes([0, 0, 1, 1]), models, bed, say)
    return pictures._png(figure)


def draw_prints(axes: Any, models: Sequence[Any], bed: Sequence[float], say: Language = ENGLISH) -> None:
    """Print with its dimensions; several prints side by side, each on its bed."""
    if not models[1:]:
        draw_print(axes, models[0], bed, say)
        return
    room = axes.get_window_extent().size
    half = 0.5 * np.array(bed[:2], float)
    cell = 2 * half * (1.06, 1.16)  # with the space for a line of text

    def columns_by_scale(columns: int) -> float:
        return float(min(room / (cell * (columns, -(-len(models) // columns)))))

    columns = max(range(1, len(models) + 1), key=columns_by_scale)
    size = float(np.clip(0.04 * columns_by_scale(columns) * cell[0] / axes.figure.dpi * 72, 3, 9))
    for number, model in enumerate(models):
        row, column = divmod(number, columns)
        middle = np.array([column, -row]) * cell
        corners, colours = _seen(model)
        axes.add_collection(PolyCollection(corners + middle, facecolors=colours, linewidths=0,
                                           antialiaseds=False, rasterized=True))
        axes.add_patch(Rectangle(middle - half, *bed[:2], fill=False, linestyle="--", edgecolor=LINE,
                                 linewidth=0.8))
        x, y, z = (float(side) for side in model.bbox)
        axes.text(*(middle + (-half[0], half[1] * 1.02)), va="bottom", color=LINE, size=size,
                  s=say("bed {number}: {x:.1f} × {y:.1f} × {z:.1f} mm", number=number + 1, x=x, y=y, z=z))
    last = cell * (columns - 1, -((len(models) - 1) // columns))
    axes.text(-half[0], last[1] - half[1] * 1.02, say("on a bed of {x:g} × {y:g} mm", x=bed[0], y=bed[1]),
              va="top", color=LINE, size=size)
    _frame(axes, (-0.5 * cell[0], last[0] + 0.5 * cell[0]), (last[1] - 0.58 * cell[1], 0.58 * cell[1]))


def draw_print(axes: Any, model: Any, bed: Sequence[float] = (), say: Language = ENGLISH) -> None:
    """Upper faces, lit, in the colours of the files; dimensions below and beside."""
    corners, colours = _seen(model)
    axes.add_collection(PolyCollection(corners, facecolors=colours, linewidths=0, antialiaseds=False,
                                       rasterized=True))
    x, y, z = (float(side) for side in model.bbox)
    gap = 0.04 * max(x, y)
    below = 8 * gap if len(bed) else 2 * gap
    room = axes.get_window_extent().size / axes.figure.dpi  # inches
    inches = max(x, y) * min(room / (x + 4.5 * gap, y + 3.5 * gap + below))
    size = float(np.clip(2 * inches, 5, 10))
    _dimension(axes, (-x / 2, -y / 2 - gap), (x / 2, -y / 2 - gap), f"{x:.1f} mm", size)
    _dimension(axes, (x / 2 + gap, -y / 2), (x / 2 + gap, y / 2), f"{y:.1f} mm", size, 90)
    high = say("{height:g} mm high", height=z)
    axes.text(x / 2, -y / 2 - 2.2 * gap, high, va="top", ha="right", color=LINE, size=size)
    if len(bed):
        inner = axes.inset_axes([-x / 2, -y / 2 - 2 * gap - below, 0.5 * x, below - 3 * gap],
                                transform=axes.transData)
        turned = not fits((x, y), bed) and fits((y, x), bed)
        _draw_bed(inner, (x, y), [float(side) for side in (bed[1::-1] if turned else bed[:2])], 0.7 * size,
                  say)
    _frame(axes, (-x / 2 - 1.5 * gap, x / 2 + 3 * gap), (-y / 2 - 2 * gap - below, y / 2 + 1.5 * gap))


def _draw_bed(axes: Any, size: tuple[float, float], bed: Sequence[float], letters: float, say: Language
              ) -> None:
    """Draw the bed and the print on it as two rectangles. letters: their size, points."""
    for (w, h), style in (((bed[0], bed[1]), {"fill": False, "linestyle": "--"}),
                          (size, {"facecolor": "#d9cfb8"})):
        axes.add_patch(Rectangle((-w / 2, -h / 2), w, h, edgecolor=LINE, linewidth=0.8, **style))
    axes.set_title(say("on a bed of {x:g} × {y:g} mm", x=bed[0], y=bed[1]), size=letters, color=LINE, pad=2,
                   loc="left")
    half = 0.51 * np.maximum(bed[:2], size)
    _frame(axes, (-half[0], half[0]), (-half[1], half[1]))
    axes.set_anchor("NW")


def _frame(axes: Any, x: tuple[float, float], y: tuple[float, float]) -> None:
    """Shows these ranges to scale, without ticks."""
    axes.set(xlim=x, ylim=y, aspect="equal")
    axes.axis("off")


def _seen(model: Any) -> tuple[np.ndarray, np.ndarray]:
    """Triangles (n x 3 x 2) that face up, the lowest first, and their colours."""
    corners, colours = [], []
    for kind in KINDS:
        if model.volumes[kind] > 0:
            V, F, _ = model.mesh(kind)
            triangles = V[F]
            normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
            triangles = triangles[normal[:, 2] > 0.05 * np.linalg.norm(normal, axis=1)]
            # Darker with depth, in bands.
            below = triangles[:, :, 2].max() - triangles[:, :, 2].mean(1)
            corners.append(triangles)
            colours.append(np.array(native.COLOURS[kind]) / 255 * (1 - 0.6 * (below % BAND) / BAND)[:, None])
    triangles, colour = np.concatenate(corners), np.concatenate(colours)
    order = np.argsort(triangles[:, :, 2].mean(1), kind="stable")
    return triangles[order][:, :, :2], colour[order]


def _dimension(axes: Any, start: tuple[float, float], end: tuple[float, float], text: str, size: float,
               turned: float = 0) -> None:
    axes.annotate("", start, end, arrowprops={"arrowstyle": "<->", "color": LINE, "linewidth": 0.8})
    axes.annotate(text, ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2), ha="center", va="center",
                  rotation=turned, color=LINE, size=size,
                  bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
