# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rings on which sheets of latex stay stretched: frames of plywood around an open window, with dowels as
teeth. The window is for washing and for pressing from behind. The sheet lies on the face that the dowels
stick out of. The two rings close on the print face to face, so the back's teeth stand half a pitch beside the
front's.

The sheet's tension bends a side of the frame within its plane, as a beam that the others hold at both ends. A
tooth is a cantilever that carries its pitch's share.
"""

from __future__ import annotations

import math
from typing import Any, Mapping

import numpy as np

THICKNESS = 12.0     # mm of plywood
MODULUS = 6000.0     # MPa, birch plywood along or across, the lesser
DOWEL = 5.0          # mm, diameter
TOOTH = 7.0          # mm that a tooth sticks out
RIM = 15.0           # mm of wood beyond the outer teeth


def teeth(block: Mapping[str, Any], side: str) -> np.ndarray:
    """Places of teeth from the window's lower left corner, mm."""
    pitch, rows = block["tooth_pitch_mm"], block["tooth_rows"]
    columns, lines = (round(size / pitch) + 2 * rows for size in block["window_mm"])
    found = [(i, j) for i in range(columns + 1) for j in range(lines + 1)
             if min(i, j, columns - i, lines - j) < rows]
    shift = 0.0 if side == "front" else 0.5
    return (np.array(found, float) - rows + shift) * pitch


def frame_width(block: Mapping[str, Any]) -> float:
    """mm of wood on each side of the window: the teeth of either ring and a rim."""
    return float((block["tooth_rows"] + 0.5) * block["tooth_pitch_mm"] + RIM)


def rings(block: Mapping[str, Any]) -> dict[str, Any]:
    """Sizes of the rings, what they carry and how they bend: N, mm, MPa; x and y. block: "sheets" of
    report.json."""
    window, width = block["window_mm"], frame_width(block)
    inertia = THICKNESS * width ** 3 / 12
    sides: dict[str, Any] = {}
    for side, load in block["load_n"].items():
        # A side along x carries the load that pulls along y, and the other way round.
        bends = [load[1 - axis] * window[axis] ** 3 / (384 * MODULUS * inertia) for axis in (0, 1)]
        tooth = max(load[axis] / window[1 - axis] for axis in (0, 1)) * block["tooth_pitch_mm"]
        sides[side] = {"load_n": load, "bends_mm": bends, "tooth_n": tooth,
                       "tooth_mpa": 32 * tooth * TOOTH / (math.pi * DOWEL ** 3)}
    return {"thickness_mm": THICKNESS, "width_mm": width, "outer_mm": [size + 2 * width for size in window],
            "dowel_mm": DOWEL, "dowel_length_mm": THICKNESS + TOOTH, "teeth": len(teeth(block, "front")),
            "tooth_height_mm": TOOTH, **sides}
