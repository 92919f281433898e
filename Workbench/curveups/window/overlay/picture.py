# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of one Design: a figure of its tiles, a second one beside it where both states are wanted, the
colours that these share; and what it was made from, and whether that is still so."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence

import FreeCAD
import numpy as np
from pivy import coin

from ...features.status import OUT_OF_DATE
from ...stages import BY_NAME
from ..qt import translate
from ..units import text_of
from . import colours, prisms
from .fields import MEMBRANE, Field
from .nodes import Markers, Outlines, Prisms, Sheet, add, fill
from .scene import Scene


class State:
    """What a scene is made from: equal for projects that are drawn alike."""

    def __init__(self, project: Any, of_target: bool):
        self._made = [project.latest(name) for name, stage in BY_NAME.items() if stage.shown]
        self._values = project.parameters.to_dict(), project.out_of_date("feasibility"), of_target

    def same(self, other: Optional["State"]) -> bool:
        return other is not None and self._values == other._values and all(
            mine is theirs for mine, theirs in zip(self._made, other._made))


def age(design: Any, one: Optional[Field], scene: Optional[Scene]) -> str:
    """Why what a field shows, or without one the tiles, is out of date; empty where it is not."""
    part = getattr(design, _slot(one, scene), None)
    if part is None or part.Status != OUT_OF_DATE:
        return ""
    return translate("CurveUps_Overlay", "out of date: {why}", why=part.Reason)


def origin_of(one: Optional[Field], scene: Scene) -> str:
    """What the values of a field, or without one the tiles, are of."""
    get = scene.parameters.get
    length, tau = text_of(get("L"), "mm", get("L")), f"{get('tau'):g}"
    return {
        "Target": translate("CurveUps_Overlay", "of the target, L = {length}", length=length),
        "Layout": translate("CurveUps_Overlay", "of the layout, L = {length}, Tau = {tau}", length=length,
                            tau=tau),
        "Verification": translate("CurveUps_Overlay", "of the verified layout, L = {length}, Tau = {tau}",
                                  length=length, tau=tau)}[_slot(one, scene)]


def _slot(one: Optional[Field], scene: Optional[Scene]) -> str:
    if one is not None:
        return one.part
    return "Target" if scene is None or scene.flat is None else "Layout"


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
        add(self.node, self.shift, self._tiles.node, self._pins_shown, self._sheets_shown, self._marks,
            self._selected.node, self._hovered.node)

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


class Picture:
    """`node` holds all of it. `t`: where between flat (0) and actuated (1) the tiles are drawn."""

    def __init__(self) -> None:
        self.node, self._placement = coin.SoSeparator(), coin.SoTransform()
        self._tile_colours = coin.SoPackedColor()
        self._sheet_colours = [coin.SoPackedColor(), coin.SoPackedColor()]
        self._figure, self._beside = (Figure(self._tile_colours, self._sheet_colours) for _ in range(2))
        self._beside_shown = coin.SoSwitch()
        self._beside_shown.addChild(self._beside.node)
        self.t = 0.0
        matt = coin.SoMaterial()
        matt.specularColor = (0, 0, 0)
        add(self.node, self._placement, matt, self._figure.node, self._beside_shown)

    @property
    def corners(self) -> np.ndarray:
        """Of the tiles as they are drawn, M x 6 x 3, mm."""
        return self._figure.corners

    def place(self, placement: Any) -> None:
        """Puts it where the Design stands."""
        self._placement.translation = tuple(placement.Base)
        self._placement.rotation = coin.SbRotation(*placement.Rotation.Q)

    def draw(self, scene: Scene, t: float, pins: bool, membranes: bool, both: bool) -> None:
        """A scene at t; `both`: flat and, beside it, actuated. Marks and outlines are drawn apart."""
        both = both and scene.flat is not None
        self.t = 1.0 if scene.flat is None else 0.0 if both else t
        self._figure.draw(scene, self.t, pins, membranes)
        self._beside_shown.whichChild = coin.SO_SWITCH_ALL if both else coin.SO_SWITCH_NONE
        if both:
            self._beside.draw(scene, 1.0, pins, membranes)
            self._beside.shift.translation = tuple(_beside(self._figure.corners, self._beside.corners))

    def colour_tiles(self, scene: Scene, one: Optional[Field], map_name: str, ends: tuple[float, float],
                     selected: Sequence[int], faded: bool) -> None:
        """By a field between the ends of its range; plain without one, or where it is the membranes'.
        faded: what is out of date."""
        if one is None or one.on == MEMBRANE:
            rgb = np.broadcast_to(np.array(colours.PLAIN), (len(scene.F), 6, 3))
        else:
            rgb = colours.sample(map_name, colours.shares(scene.slots(one), *ends))
        found = colours.packed(colours.faded(rgb) if faded else rgb)
        found[list(selected)] = colours.packed(np.array(_selection()))
        fill(self._tile_colours.orderedRGBA, found.ravel())

    def colour_sheets(self, scene: Scene, one: Optional[Field], map_name: str, ends: tuple[float, float],
                      faded: bool) -> None:
        """The membranes, by a field of theirs."""
        start = 0
        for node, membrane in zip(self._sheet_colours, scene.membranes):
            count = len(membrane.triangles)
            if one is not None and one.on == MEMBRANE:
                shares = colours.shares(one.values[start : start + count], *ends)
                rgb = colours.sample(map_name, shares)
                found = colours.packed(colours.faded(rgb) if faded else rgb)
            else:
                found = np.full(count, colours.packed(np.array(colours.MEMBRANE)), np.uint32)
            start += count
            fill(node.orderedRGBA, found)

    def mark(self, scene: Scene, fields: Iterable[Field]) -> None:
        """Marks the problems of fields by their shapes."""
        for figure in self._drawn():
            figure.mark({one.mark: scene.places(one, one.problems, figure.corners) for one in fields})

    def outline(self, selected: Sequence[int], hovered: Sequence[int]) -> None:
        """Rims of tiles by number."""
        highlight = _preferred("HighlightColor", (0.88, 0.88, 0.08))
        for figure in self._drawn():
            figure.outline(selected, hovered, _selection(), highlight)

    def tile_of(self, picked: Any) -> int:
        """The tile that a SoPickedPoint is on; -1 where it is none."""
        tile = self._figure.tile_of(picked)
        return tile if tile >= 0 else self._beside.tile_of(picked)

    def figures(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Corners of what is drawn (M x 6 x 3, mm) and its place beside the design's, for picking."""
        found = [(self._figure.corners, np.zeros(3))]
        if self._beside_shown.whichChild.getValue() != coin.SO_SWITCH_NONE:
            shift = np.array(self._beside.shift.translation.getValue().getValue())
            found.append((self._beside.corners, shift))
        return found

    def _drawn(self) -> list[Figure]:
        return [figure for figure in (self._figure, self._beside) if len(figure.corners)]


def _beside(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Where to put the second of two figures so that it stands beside the first and as high."""
    low, high = first.reshape(-1, 3).min(0), first.reshape(-1, 3).max(0)
    other_low, other_high = second.reshape(-1, 3).min(0), second.reshape(-1, 3).max(0)
    shift = (low + high) / 2 - (other_low + other_high) / 2
    shift[0] = high[0] + 0.1 * (high[0] - low[0]) - other_low[0]
    shift[2] = low[2] - other_low[2]
    return shift


def _selection() -> tuple[float, float, float]:
    return _preferred("SelectionColor", (0.11, 0.68, 0.11))


def _preferred(name: str, default: tuple[float, float, float]) -> tuple[float, float, float]:
    """A colour of the user's preferences."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    number = group.GetUnsigned(name, int(colours.packed(np.array(default))))
    return tuple((number >> shift & 255) / 255 for shift in (24, 16, 8))  # type: ignore[return-value]
