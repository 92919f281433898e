# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts on the flat layout and on the target, each with its number."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

from ..base.edges import sides_of_edges
from . import pictures

MADE, PROPOSED = "#1565c0", "#d81b60"


def cut_view(design: Any, cuts: Sequence[dict], width: float = 10.0) -> bytes:
    """Layout on the left, target from two sides on the right; `cuts` as in report.json."""
    flat = np.asarray(design.T)
    low, high = pictures._bounds(flat)
    height = float(np.clip(0.5 * width * (high[1] - low[1]) / (high[0] - low[0]), 4, 10))
    figure = Figure(figsize=(width, height))
    layout = figure.add_axes([0.01, 0.02, 0.5, 0.96])
    pictures._draw_flat(layout, design, None)
    layout.axis("off")
    front = figure.add_axes([0.53, 0.51, 0.46, 0.47])
    behind = figure.add_axes([0.53, 0.02, 0.46, 0.47])
    sides = sides_of_edges(design.F)
    on_shape = []
    for number, cut in enumerate(cuts, 1):
        colour = MADE if cut["applied"] else PROPOSED
        edges = [(min(edge), max(edge)) for edge in cut["edges"]]
        lips = [flat[tile][[t, (t + 1) % 3]] for edge in edges for tile, t in sides[edge]]
        layout.add_collection(LineCollection(lips, colors=colour, linewidths=2))
        layout.annotate(str(number), np.mean(lips[len(lips) // 2], axis=0), color=colour,
                        fontsize=12, fontweight="bold")
        on_shape += [(*side, colour) for edge in edges for side in sides[edge]]
    for axes, turned in ((front, False), (behind, True)):
        pictures._draw_actuated(axes, design, turned, lines=on_shape)
    return pictures._png(figure)
