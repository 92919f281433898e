# SPDX-License-Identifier: LGPL-2.1-or-later
"""One drawing of a scene: its tiles somewhere between flat and actuated, with what belongs to them."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
from pivy import coin

from . import colours, prisms
from .nodes import Markers, Outlines, Prisms, Sheet
from .scene import Scene


class Figure:
    """`node` holds all of it. The flat and the actuated tiles side by side are two figures that share
    their colours, so that a tile looks the same in both."""

    def __init__(self, tile_colours: Any, sheet_colours: Sequence[Any]):
        """SoPackedColor nodes: six colours a tile, and one a triangle of either membrane."""
        self.node = coin.SoSeparator()
        self.corners = np.empty((0, 6, 3))  # of the tiles as they are drawn, mm
        self.shift = coin.SoTranslation()
        self._tiles = Prisms(prisms.THIRDS, tile_colours)
        pin_colour = coin.SoPackedColor()
        pin_colour.orderedRGBA = int(colours.packed(np.array(colours.PIN)))
        self._pins, self._pins_shown = Prisms(prisms.WHOLE, pin_colour), coin.SoSwitch()
        self._pins_shown.addChild(self._pins.node)
        self._sheets, self._sheets_shown = [Sheet(colour) for colour in sheet_colours], coin.SoSwitch()
        for sheet in self._sheets:
            self._sheets_shown.addChild(sheet.node)
        self._marks = coin.SoSeparator()
        self._selected, self._hovered = Outlines(3), Outlines(3)
        for part in (self.shift, self._tiles.node, self._pins_shown, self._sheets_shown, self._marks,
                     self._selected.node, self._hovered.node):
            self.node.addChild(part)

    def draw(self, scene: Scene, t: float, pins: bool, membranes: bool) -> None:
        """The scene at t from 0, flat, to 1, actuated. Marks and outlines are drawn apart."""
        self.corners = scene.tiles_at(t)
        self._tiles.set_corners(self.corners)
        self._show(self._pins_shown, pins and len(scene.actuated_pins) > 0)
        if pins and len(scene.actuated_pins):
            self._pins.set_corners(prisms.pin_prisms(scene.pins_at(t)))
        known = [scene.membrane_at(sheet, t) for sheet in scene.membranes] if membranes else []
        self._show(self._sheets_shown, bool(known))
        for sheet, membrane, points in zip(self._sheets, scene.membranes, known):
            sheet.set_shape(points, membrane.triangles)

    def mark(self, places: Mapping[str, np.ndarray]) -> None:
        """Marks by their shape at points (K x 3, mm)."""
        self._marks.removeAllChildren()
        for shape, points in places.items():
            if len(points):
                markers = Markers(shape, colours.MARK)
                markers.set_points(points)
                self._marks.addChild(markers.node)

    def outline(self, selected: Sequence[int], hovered: Sequence[int], selection: tuple,
                highlight: tuple) -> None:
        """Rims of tiles by number, in the colours of selection and highlight."""
        self._selected.set_corners(self.corners[list(selected)], selection)
        self._hovered.set_corners(self.corners[list(hovered)], highlight)

    def tile_of(self, picked: Any) -> int:
        """The tile that a SoPickedPoint is on, by itself or by its pins; -1 where it is none of these."""
        tile = self._tiles.prism_of(picked)
        if tile < 0:
            pin = self._pins.prism_of(picked)
            tile = pin % len(self.corners) if pin >= 0 else -1
        return tile

    @staticmethod
    def _show(switch: Any, shown: bool) -> None:
        switch.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE
