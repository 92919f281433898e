# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the stretch of both membranes of the actuated print on the flat layout."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from . import pictures

SIDES = ("front", "back")
TAUT, WRINKLED, SLACK = range(3)  # as the native module numbers tension
WRINKLE, LOOSE = "#d81b60", "#b9b4aa"


def stretch_view(membranes: Sequence[Any], width: float = 10.0) -> bytes:
    """Both membranes side by side, coloured by the larger principal stretch on one scale; wrinkled
    triangles are tinted, slack ones grey. `membranes`: front and back, each with the arrays of a
    native MembranePicture."""
    low, high = pictures._bounds(np.vstack([m["flat"] for m in membranes]))
    below, above = 0.75, 0.3  # inches, for the legend and the axis, and for titles
    height = 0.405 * width * (high[1] - low[1]) / (high[0] - low[0])
    height = float(np.clip(height, 2.2, 10)) + below + above
    figure = Figure(figsize=(width, height))
    scale = _scale(membranes)
    for column, (name, membrane) in enumerate(zip(SIDES, membranes)):
        axes = figure.add_axes([0.05 + 0.455 * column, below / height, 0.405,
                                1 - (below + above) / height])
        drawn = _draw(axes, membrane, scale)
        pictures._frame(axes, low, high)
        axes.set_title(name)
        axes.set_xlabel("mm")
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
    figure.colorbar(drawn, cax=figure.add_axes([0.935, 0.2, 0.015, 0.65]), extend="both",
                    label="larger principal stretch")
    found = np.concatenate([np.asarray(m["tension"]) for m in membranes])
    marks = [Patch(facecolor=colour, label=label) for kind, colour, label in
             ((WRINKLED, WRINKLE, "wrinkled: tinted"), (SLACK, LOOSE, "slack")) if (found == kind).any()]
    if marks:
        figure.legend(handles=marks, loc="lower center", ncol=2, frameon=False)
    return pictures._png(figure, scale=True)


def _scale(membranes: Sequence[Any]) -> Normalize:
    """From the first to the 99th hundredth of what carries tension: single triangles at corners of
    pins stretch much further and would leave one colour for all others."""
    carried = [np.asarray(m["stretch"])[np.asarray(m["tension"]) != SLACK, 0] for m in membranes]
    values = np.concatenate(carried)
    if not len(values):
        return Normalize(1.0, 2.0)
    low, high = np.percentile(values, [1, 99])
    return Normalize(low, max(high, low + 1e-3))


def _draw(axes: Any, membrane: Any, scale: Normalize) -> PolyCollection:
    """One membrane. Triangles are drawn without smooth edges, which would leave seams and take longer."""
    corners = np.asarray(membrane["flat"])[np.asarray(membrane["triangles"])]
    tension = np.asarray(membrane["tension"])
    values = np.ma.array(np.asarray(membrane["stretch"])[:, 0], mask=tension == SLACK)
    drawn = PolyCollection(corners, array=values, norm=scale, cmap="viridis", edgecolors="face",
                           linewidths=0.2, antialiaseds=False)
    drawn.cmap = drawn.cmap.with_extremes(bad=LOOSE)
    axes.add_collection(drawn)
    if (tension == WRINKLED).any():
        axes.add_collection(PolyCollection(corners[tension == WRINKLED], facecolors=WRINKLE,
                                           edgecolors="none", alpha=0.5, antialiaseds=False))
    return drawn
