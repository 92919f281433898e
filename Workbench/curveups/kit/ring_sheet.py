# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plywood of a stretching ring, for a laser or a saw and a drill, at full size."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from .drawing import Drawing, dxf
from .kit import Kit
from .ring import DOWEL, RIM, THICKNESS, frame_width, teeth


def make(kit: Kit, side: str) -> bytes:
    """The plywood of a side's ring, as DXF."""
    return dxf(frame(f"{kit.title}, {side} ring", kit.report["sheets"], side))


def frame(title: str, block: Mapping[str, Any], side: str) -> Drawing:
    """The face with the teeth. Layer cut: outline, window and holes at the corners for dowels that align both
    rings; layer control: holes of teeth."""
    width = frame_width(block)
    window = np.array(block["window_mm"])
    outer = window + 2 * width
    drawing = Drawing(title, (float(outer[0]), float(outer[1])))
    drawing.box("cut", 0, 0, *map(float, outer))
    drawing.box("cut", width, width, *map(float, window))
    for x in (RIM / 2, float(outer[0]) - RIM / 2):
        for y in (RIM / 2, float(outer[1]) - RIM / 2):
            drawing.circle("cut", x, y, DOWEL / 2)
    for tooth in teeth(block, side) + width:
        drawing.circle("control", float(tooth[0]), float(tooth[1]), DOWEL / 2)
    drawing.text(RIM, 2.0, 5.0, f"{title}: {THICKNESS:g} mm plywood, holes {DOWEL:g} mm")
    return drawing
