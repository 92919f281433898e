# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of one Design: a figure of its tiles, a second one beside it if both ends are shown, and the
colours that these share; what it was made from, and whether that is out of date."""

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
from .nodes import Outlines, Prisms, Sheet, add, fill, markers, separator
from .scene import Scene


class State:
    """Results and values from which a scene is made."""

    def __init__(self, project: Any, of_target: bool):
        self._results = [project.latest(name) for name, stage in BY_NAME.items() if stage.shown]
        self._values = project.parameters.to_dict(), project.out_of_date("feasibility"), of_target

    def same(self, other: Optional["State"]) -> bool:
        """True if both give the same scene."""
        return other is not None and self._values == other._values and all(
            mine is theirs for mine, theirs in zip(self._results, other._results))


def age(design: Any, field: Optional[Field], scene: Optional[Scene]) -> str:
    """Reason why values of a field, or the tiles without one, are out of date; empty if they are not."""
    part = getattr(design, _slot(field, scene), None)
    if part is None or part.Status != OUT_OF_DATE:
        return ""
    return translate("CurveUps_Overlay", "out of date: {why}", why=part.Reason)


def origin_of(field: Optional[Field], scene: Scene) -> str:
    """Layout or target of the values of a field, or of the tiles without one."""
    get = scene.parameters.get
    values = {"length": text_of(get("L"), "mm", get("L")), "tau": f"{get('tau'):g}"}
    return {
        "Target": translate("CurveUps_Overlay", "of the target, L = {length}", **values),
        "Layout": translate("CurveUps_Overlay", "of the layout, L = {length}, Tau = {tau}", **values),
        "Verification": translate("CurveUps_Overlay", "of the verified layout, L = {length}, Tau = {tau}",
                                  **values)}[_slot(field, scene)]


def _slot(field: Optional[Field], scene: Optional[Scene]) -> str:
    if field is not None:
        return field.part
    return "Target" if scene is None or scene.flat is None else "Layout"


class Figure:
    """Tiles at one point of the way from flat to actuated, drawn by `node`. Two figures side by side share
    their colours, so that a tile looks the same in both."""

    def __init__(self, tile_colours: Any, sheet_colours: Sequence[Any]):
        """SoPackedColor nodes: six colours a tile, and one a triangle of either membrane."""
        self.corners = np.empty((0, 6, 3))  # of the tiles as they are drawn, mm
        self.shift = coin.SoTranslation()
        self._tiles = Prisms(prisms.THIRDS, tile_colours)
        pin_colour = coin.SoPackedColor()
        pin_colour.orderedRGBA = int(colours.packed(np.array(colours.PIN)))
        self._pins, self._pins_shown = Prisms(prisms.WHOLE, pin_colour), coin.SoSwitch()
        self._pins_shown.addChild(self._pins.node)
        self._sheets, self._sheets_shown = [Sheet(colour) for colour in sheet_colours], coin.SoSwitch()
        add(self._sheets_shown, *(sheet.node for sheet in self._sheets))
        self._marks = coin.SoSeparator()
        self._selected, self._hovered = Outlines(3), Outlines(3)
        self.node = separator(self.shift, self._tiles.node, self._pins_shown, self._sheets_shown, self._marks,
                              self._selected.node, self._hovered.node)

    def draw(self, scene: Scene, t: float, pins: bool, membranes: bool) -> None:
        """Draw the scene at t from 0, flat, to 1, actuated, without marks and outlines."""
        self.corners = scene.tiles_at(t)
        self._tiles.set_corners(self.corners)
        pins = pins and len(scene.actuated_pins) > 0
        _show(self._pins_shown, pins)
        if pins:
            self._pins.set_corners(prisms.pin_prisms(scene.pins_at(t)))
        drawn = scene.membranes if membranes else ()
        _show(self._sheets_shown, bool(drawn))
        for sheet, membrane in zip(self._sheets, drawn):
            sheet.set_shape(scene.membrane_at(membrane, t), membrane.triangles)

    def mark(self, places: Mapping[str, np.ndarray]) -> None:
        """Draw marks by their shape at points (K x 3, mm)."""
        self._marks.removeAllChildren()
        add(self._marks, *(markers(shape, colours.MARK, points) for shape, points in places.items()))

    def outline(self, selected: Sequence[int], hovered: Sequence[int]) -> None:
        """Draw rims of tiles by number, in FreeCAD's colours of selection and highlight."""
        self._selected.set_corners(self.corners[list(selected)], _selection())
        self._hovered.set_corners(self.corners[list(hovered)],
                                  _preferred("HighlightColor", (0.88, 0.88, 0.08)))

    def tile_of(self, picked: Any) -> int:
        """Tile at a SoPickedPoint on a tile or a pin; -1 if it is on neither."""
        tile = self._tiles.prism_of(picked)
        if tile < 0:
            pin = self._pins.prism_of(picked)
            tile = pin % len(self.corners) if pin >= 0 else -1
        return tile


class Picture:
    """Figures of a scene, drawn by `node`. `t`: their point of the way from flat (0) to actuated (1)."""

    def __init__(self) -> None:
        self._placement, matt = coin.SoTransform(), coin.SoMaterial()
        self._tile_colours = coin.SoPackedColor()
        self._sheet_colours = [coin.SoPackedColor(), coin.SoPackedColor()]
        self._figure, self._beside = (Figure(self._tile_colours, self._sheet_colours) for _ in range(2))
        self._beside_shown = coin.SoSwitch()
        self._beside_shown.addChild(self._beside.node)
        self.t = 0.0
        matt.specularColor = (0, 0, 0)
        self.node = separator(self._placement, matt, self._figure.node, self._beside_shown)

    @property
    def corners(self) -> np.ndarray:
        """Corners of the tiles as they are drawn, M x 6 x 3, mm."""
        return self._figure.corners

    def place(self, placement: Any) -> None:
        """Move it to the placement of the Design."""
        self._placement.translation = tuple(placement.Base)
        self._placement.rotation = coin.SbRotation(*placement.Rotation.Q)

    def draw(self, scene: Scene, t: float, pins: bool, membranes: bool, both: bool) -> None:
        """Draw a scene at t, or both flat and, beside it, actuated; without marks and outlines."""
        both = both and scene.flat is not None
        self.t = 1.0 if scene.flat is None else 0.0 if both else t
        self._figure.draw(scene, self.t, pins, membranes)
        _show(self._beside_shown, both)
        if both:
            self._beside.draw(scene, 1.0, pins, membranes)
            self._beside.shift.translation = tuple(_shift(self._figure.corners, self._beside.corners))

    def colour_tiles(self, scene: Scene, field: Optional[Field], map_name: str, ends: tuple[float, float],
                     selected: Sequence[int], faded: bool) -> None:
        """Colour by a field between the ends of its range; plain without one, or if it is the membranes'."""
        if field is None or field.on == MEMBRANE:
            rgb = np.broadcast_to(np.array(colours.PLAIN), (len(scene.F), 6, 3))
        else:
            rgb = colours.sample(map_name, colours.shares(scene.slots(field), *ends))
        packed = colours.packed(colours.faded(rgb) if faded else rgb)
        packed[list(selected)] = colours.packed(np.array(_selection()))
        fill(self._tile_colours.orderedRGBA, packed.ravel())

    def colour_sheets(self, scene: Scene, field: Optional[Field], map_name: str, ends: tuple[float, float],
                      faded: bool) -> None:
        """Colour the membranes by a field of theirs."""
        start = 0
        for node, membrane in zip(self._sheet_colours, scene.membranes):
            count = len(membrane.triangles)
            rgb = np.broadcast_to(np.array(colours.MEMBRANE), (count, 3))
            if field is not None and field.on == MEMBRANE:
                shares = colours.shares(field.values[start : start + count], *ends)
                rgb = colours.sample(map_name, shares)
                rgb = colours.faded(rgb) if faded else rgb
            start += count
            fill(node.orderedRGBA, colours.packed(rgb))

    def mark(self, scene: Scene, fields: Iterable[Field]) -> None:
        """Mark the problems of fields by their shapes."""
        for figure in self._drawn():
            figure.mark({field.mark: scene.places(field, field.problems, figure.corners) for field in fields})

    def outline(self, selected: Sequence[int], hovered: Sequence[int]) -> None:
        """Draw rims of tiles by number."""
        for figure in self._drawn():
            figure.outline(selected, hovered)

    def tile_of(self, picked: Any) -> int:
        """Tile at a SoPickedPoint; -1 if there is none."""
        tile = self._figure.tile_of(picked)
        return tile if tile >= 0 else self._beside.tile_of(picked)

    def figures(self) -> list[tuple[np.ndarray, np.ndarray]]:
        """Corners of the figures (M x 6 x 3, mm), each with its shift from the design's placement."""
        figures = [(self._figure.corners, np.zeros(3))]
        if self._beside_shown.whichChild.getValue() != coin.SO_SWITCH_NONE:
            shift = np.array(self._beside.shift.translation.getValue().getValue())
            figures.append((self._beside.corners, shift))
        return figures

    def _drawn(self) -> list[Figure]:
        return [figure for figure in (self._figure, self._beside) if len(figure.corners)]


def _show(switch: Any, shown: bool) -> None:
    switch.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE


def _shift(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Shift that puts the second of two figures beside the first, as high."""
    low, high = first.reshape(-1, 3).min(0), first.reshape(-1, 3).max(0)
    other_low, other_high = second.reshape(-1, 3).min(0), second.reshape(-1, 3).max(0)
    shift = (low + high) / 2 - (other_low + other_high) / 2
    shift[0] = high[0] + 0.1 * (high[0] - low[0]) - other_low[0]
    shift[2] = low[2] - other_low[2]
    return shift


def _selection() -> tuple[float, ...]:
    return _preferred("SelectionColor", (0.11, 0.68, 0.11))


def _preferred(name: str, default: tuple[float, ...]) -> tuple[float, ...]:
    """A colour of the user's preferences."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    number = group.GetUnsigned(name, int(colours.packed(np.array(default))))
    return tuple((number >> shift & 255) / 255 for shift in (24, 16, 8))
