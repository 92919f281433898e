# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines on a design's overlay along edges between tiles, wherever the tiles are drawn just now."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Sequence

import numpy as np
from pivy import coin

from ...stages.cut_request import sides_of_edges
from .nodes import fill, unlit, unpickable

# Apart in lightness as well as in hue.
COLOURS = {"cut": (0.0, 0.0, 0.0), "selected": (0.90, 0.62, 0.0), "hovered": (0.34, 0.71, 0.91),
           "suggested": (0.84, 0.37, 0.0)}
_WIDTHS = {"cut": 5.0, "selected": 7.0, "hovered": 6.0, "suggested": 4.0}


class CutLines:
    """Added to an Overlay until it is closed."""

    def __init__(self, overlay: Any):
        self._overlay = overlay
        self._F: Any = None
        self._sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
        self.node = coin.SoSeparator()
        self.node.addChild(unpickable())
        self.node.addChild(unlit())
        self._lines = {kind: self._add_lines(COLOURS[kind], _WIDTHS[kind]) for kind in COLOURS}
        overlay.node.addChild(self.node)

    def close(self) -> None:
        self._overlay.node.removeChild(self.node)

    def draw(self, kinds: Mapping[str, Iterable[Sequence[int]]]) -> None:
        """kinds: pairs of vertices by kind of line."""
        scene = self._overlay.scene
        if scene is None:
            return
        if scene.F is not self._F:
            self._F, self._sides = scene.F, sides_of_edges(scene.F)
        figures = self._overlay.figures()
        for kind, (points, lines) in self._lines.items():
            sides = [side for a, b in kinds.get(kind, ())
                     for side in self._sides.get((min(a, b), max(a, b)), ())]
            found = [self._ends(corners, shift, sides) for corners, shift in figures] if sides else []
            places = np.concatenate(found) if found else np.zeros((0, 3))
            lines.numVertices.setNum(0)
            fill(points.point, places)
            fill(lines.numVertices, np.full(len(places) // 2, 2, np.int32))

    def _ends(self, corners: np.ndarray, shift: np.ndarray, sides: list[tuple[int, int]]) -> np.ndarray:
        tile, k = np.array(sides).T
        return (np.stack([corners[tile, k], corners[tile, (k + 1) % 3]], axis=1) + shift).reshape(-1, 3)

    def _add_lines(self, colour: tuple, width: float) -> tuple[Any, Any]:
        part, style, points, lines = (coin.SoSeparator(), coin.SoDrawStyle(), coin.SoCoordinate3(),
                                      coin.SoLineSet())
        style.lineWidth = width
        shade = coin.SoBaseColor()
        shade.rgb = colour
        for node in (shade, style, points, lines):
            part.addChild(node)
        self.node.addChild(part)
        points.point.setNum(0)
        lines.numVertices.setNum(0)
        return points, lines
