# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of tiles: their numbers, for which tiles themselves are too small, from the front and, mirrored,
from the back."""

from __future__ import annotations

import numpy as np

from ..base.language import Text
from .drawing import Drawing, svg
from .kit import Kit

LEAST_EDGE = 14.0  # mm of a tile on the map, so that its number can be read
LETTERS = 2.0      # mm
MARGIN = 8.0


def make(kit: Kit) -> bytes:
    """As SVG; tiles of the weakest contacts on the layer cut."""
    return svg(tile_map(kit))


def tile_map(kit: Kit) -> Drawing:
    """The front on the left, the back on the right."""
    corners = np.asarray(kit.results.design.T)
    edge = float(np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).mean())
    corners = corners * max(1.0, LEAST_EDGE / edge)
    low, high = corners.reshape(-1, 2).min(0), corners.reshape(-1, 2).max(0)
    width, height = map(float, high - low)
    size = (2 * width + 3 * MARGIN, height + 3 * MARGIN)
    drawing = Drawing(kit.say("{title}, tiles", title=kit.title), size)
    weak = set(kit.weak_tiles.tolist())
    front = corners - low + MARGIN
    back = front * (-1, 1) + (2 * width + 3 * MARGIN, 0)
    drawing.text(MARGIN, height + 2.2 * MARGIN, 3.0, kit.say("{title}: 12 is T00012", title=kit.title))
    for text, half, x in ((Text("front"), front, MARGIN),
                          (Text("back, mirrored"), back, width + 2 * MARGIN)):
        drawing.text(x, height + 1.5 * MARGIN, 3.0, kit.say(text))
        for tile, outline in enumerate(half):
            drawing.closed("cut" if tile in weak else "grid", outline)
            x, y = map(float, outline.mean(0))
            drawing.centred(x, y, LETTERS, str(tile + 1))
    return drawing
