# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of the tiles that hands press of a jammed piece."""

from __future__ import annotations

from types import SimpleNamespace
import numpy as np

from ..base.motions import rigid_motion
from ..stages.actuation import Actuation
from . import pictures
from .moving import front_corners
from .pictures import WEAK, camera, in_view, two_sides

ARROW = 0.08  # of the picture's width


def hands_view(found: Actuation) -> bytes:
    """The piece before hands press it, turned to where it was designed, from two sides; the tiles that they
    press are red, with an arrow each."""
    block = found.block
    rows = found.frame(found.path_count + block["by_hand"]["shaken_frame"])
    corners = front_corners(found.design, rows).reshape(-1, 3)
    actuated = np.asarray(found.design.V)[np.asarray(found.design.F)].reshape(-1, 3)
    R, t = rigid_motion(corners, actuated)
    piece = SimpleNamespace(V=corners @ R.T + t, F=np.arange(len(corners)).reshape(-1, 3))
    colours = np.full((len(piece.F), 3), (0.92, 0.86, 0.74))
    colours[found.pressed_tiles] = [int(WEAK[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    figure, _ = two_sides(piece.V, piece.F, colours)
    seen_by = camera(piece.V, piece.F)
    for axes, turned in zip(figure.axes, (False, True)):
        low, high = axes.get_xlim()
        for touch in block["hands"]:
            tips = in_view(piece.V[piece.F[touch["tiles"]]].mean(1), piece.V, seen_by, turned)[:, :2]
            way = in_view(np.array([touch["direction"]]), None, seen_by, turned)[0, :2]
            for tip in tips:
                axes.annotate("", xy=tip, xytext=tip - ARROW * (high - low) * way, annotation_clip=False,
                              arrowprops={"arrowstyle": "-|>", "color": "#1c1c1c", "lw": 0.9})
    return pictures._png(figure)
