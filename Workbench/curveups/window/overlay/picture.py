# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of one Design in Coin: a figure of its tiles, a second one beside it if both ends are shown,
and the colours that these share; what it was made from, and whether that is out of date.

There is one set of nodes for each kind of thing, whatever their count. Arrays are set as a whole: one element
at a time takes seconds.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterable, Mapping, Optional, Sequence

import FreeCAD
import numpy as np
from pivy import coin

from ...features.status import OUT_OF_DATE
from ...stages import BY_NAME
from ..qt import translate
from ..units import text_of
from . import colours
from .fields import MEMBRANE, Field
from .scene import THIRDS, WHOLE, Scene, Topology, line_index, normals, pin_prisms, with_middles

_AREA_WITH_RIMS = 90.0  # px2 of the screen a prism; below, lines would drown its colours


def fill(field: Any, values: np.ndarray) -> None:
    """Set all values of a multiple-value field."""
    count = len(values)
    if values.dtype == np.uint32:  # pivy takes numbers of this kind faster, and in all versions, as a list
        values = values.tolist()
    elif values.dtype != np.int32:
        values = np.ascontiguousarray(values, np.float32)
    field.setNum(count)
    if count:
        field.setValues(0, count, values)


def add(group: Any, *parts: Any) -> None:
    """Add nodes to a group."""
    for part in parts:
        group.addChild(part)


def separator(*parts: Any) -> Any:
    """A separator with these nodes."""
    node = coin.SoSeparator()
    add(node, *parts)
    return node


def coloured(rgb: Any) -> Any:
    """Colour (three numbers from 0 to 1) of the nodes that follow."""
    node = coin.SoBaseColor()
    node.rgb = tuple(float(x) for x in rgb[:3])
    return node


def unlit() -> Any:
    """Colours as they are, whatever the light."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def unpickable() -> Any:
    """Nodes that follow are not picked."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def lines_of(width: float) -> Any:
    """Width of the lines that follow, px."""
    style = coin.SoDrawStyle()
    style.lineWidth = width
    return style


class Prisms:
    """Prisms with one colour for each of their slots, and their rims as lines."""

    def __init__(self, topology: Topology, colours: Any):
        """colours: a SoPackedColor, which several sets may share."""
        self._topology, self._count = topology, -1
        self._corners, self._points = coin.SoCoordinate3(), coin.SoCoordinate3()
        self._normals, self._faces = coin.SoNormal(), coin.SoIndexedFaceSet()
        self._lines = coin.SoIndexedLineSet()
        hints = coin.SoShapeHints()
        hints.vertexOrdering, hints.faceType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.CONVEX
        hints.shapeType = coin.SoShapeHints.SOLID
        facets, materials = coin.SoNormalBinding(), coin.SoMaterialBinding()
        facets.value = coin.SoNormalBinding.PER_FACE_INDEXED
        materials.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        behind = coin.SoPolygonOffset()
        behind.factor = behind.units = 1.0
        faces = separator(hints, colours, self._points, self._normals, facets, materials, behind,
                          self._faces)
        lines = separator(_overall((0.15, 0.15, 0.15)), unpickable(), self._corners, self._lines)
        faces.renderCaching = lines.renderCaching = coin.SoSeparator.ON
        self._rims = coin.SoLevelOfDetail()
        add(self._rims, lines, coin.SoInfo())
        # FreeCAD's actions of selection enter groups, and FreeCAD 1.1 ends in a level of detail. They pass
        # kits by.
        kit = coin.SoWrapperKit()
        kit.setPart("contents", separator(self._rims))
        self.node = separator(faces, kit)
        self.node.renderCaching = coin.SoSeparator.OFF  # nodes that depend on the camera gain nothing by it

    def set_corners(self, corners: np.ndarray) -> None:
        """Draw prisms with these corners, M x 6 x 3, mm."""
        if len(corners) != self._count:
            self._set_count(len(corners))
        points = with_middles(corners) if self._topology.points == 8 else corners
        fill(self._points.point, points.reshape(-1, 3))
        fill(self._corners.point, corners.reshape(-1, 3))
        fill(self._normals.vector, normals(corners).reshape(-1, 3))

    def _set_count(self, count: int) -> None:
        # Indices go first, or faces would point beyond fewer coordinates.
        self._count = count
        for field in (self._faces.coordIndex, self._lines.coordIndex):
            field.setNum(0)
        fill(self._faces.coordIndex, self._topology.coordinate_index(count))
        fill(self._faces.normalIndex, self._topology.normal_index(count))
        fill(self._faces.materialIndex, self._topology.colour_index(count))
        fill(self._lines.coordIndex, line_index(count))
        self._rims.screenArea.setValue(_AREA_WITH_RIMS * count)

    def prism_of(self, picked: Any) -> int:
        """Number of the prism at a SoPickedPoint; -1 if that is on something else."""
        detail = picked.getDetail(self._faces)
        if detail is None or detail.getTypeId() != coin.SoFaceDetail.getClassTypeId():
            return -1
        return coin.cast(detail, "SoFaceDetail").getFaceIndex() // len(self._topology.polygons)


_SHAPES = {"cross": "CROSS_7_7", "triangle": "TRIANGLE_FILLED_7_7", "square": "SQUARE_FILLED_7_7",
           "diamond": "DIAMOND_LINE_7_7"}


def markers(shape: str, rgb: tuple[float, float, float], points: np.ndarray) -> Any:
    """Marks of a shape at points (K x 3, mm), of the same size at any distance, on white discs that set them
    off from any colour."""
    coordinates, disc, mark = coin.SoCoordinate3(), coin.SoMarkerSet(), coin.SoMarkerSet()
    disc.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
    mark.markerIndex = getattr(coin.SoMarkerSet, _SHAPES[shape])
    fill(coordinates.point, points)
    depth = coin.SoDepthBuffer()
    depth.write = False  # otherwise the disc hides its mark, which is no nearer
    return separator(unpickable(), depth, coordinates, _overall((1, 1, 1)), disc, _overall(rgb), mark)


class Sheet:
    """A membrane: triangles with a colour each."""

    def __init__(self, colours: Any):
        """colours: a SoPackedColor, one a triangle."""
        self._points, self._faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        self._drawn: Optional[np.ndarray] = None
        hints, materials = coin.SoShapeHints(), coin.SoMaterialBinding()
        hints.vertexOrdering, hints.faceType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.CONVEX
        materials.value = coin.SoMaterialBinding.PER_FACE
        self.node = separator(hints, unpickable(), colours, materials, self._points, self._faces)
        self.node.renderCaching = coin.SoSeparator.ON

    def set_shape(self, points: np.ndarray, triangles: np.ndarray) -> None:
        """Draw triangles (K x 3) of points (P x 3, mm)."""
        others = triangles is not self._drawn
        if others:
            self._faces.coordIndex.setNum(0)
        fill(self._points.point, points)
        if others:
            index = np.full((len(triangles), 4), -1, np.int32)
            index[:, :3] = triangles
            fill(self._faces.coordIndex, index.ravel())
            self._drawn = triangles


def _overall(rgb: tuple[float, float, float]) -> Any:
    """A single unlit colour for all that follows."""
    group, binding = coin.SoGroup(), coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.OVERALL
    add(group, unlit(), coloured(rgb), binding)
    return group


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


@dataclass(frozen=True)
class Colouring:
    """Colours of values. field: None for plain tiles. map_name, low, high: of its values. faded: they are
    out of date."""

    field: Optional[Field]
    map_name: str
    low: float
    high: float
    faded: bool

    def of(self, values: np.ndarray) -> np.ndarray:
        """Colours (0 to 1, ... x 3) of values."""
        return self.paled(colours.sample(self.map_name, colours.shares(values, self.low, self.high)))

    def paled(self, rgb: np.ndarray) -> np.ndarray:
        return colours.faded(rgb) if self.faded else rgb


class Figure:
    """Tiles at one point of the way from flat to actuated, drawn by `node`. Two figures side by side share
    their colours, so that a tile looks the same in both."""

    def __init__(self, tile_colours: Any, sheet_colours: Sequence[Any]):
        """SoPackedColor nodes: six colours a tile, and one a triangle of either membrane."""
        self.corners = np.empty((0, 6, 3))  # of the tiles as they are drawn, mm
        self.shift = coin.SoTranslation()
        self._tiles = Prisms(THIRDS, tile_colours)
        pin_colour = coin.SoPackedColor()
        pin_colour.orderedRGBA = int(colours.packed(np.array(colours.PIN)))
        self._pins, self._pins_shown = Prisms(WHOLE, pin_colour), coin.SoSwitch()
        self._pins_shown.addChild(self._pins.node)
        self._sheets, self._sheets_shown = [Sheet(colour) for colour in sheet_colours], coin.SoSwitch()
        add(self._sheets_shown, *(sheet.node for sheet in self._sheets))
        self._marks = coin.SoSeparator()
        self.node = separator(self.shift, self._tiles.node, self._pins_shown, self._sheets_shown, self._marks)

    def draw(self, scene: Scene, t: float, pins: bool, membranes: bool) -> None:
        """Draw the scene at t from 0, flat, to 1, actuated, without marks."""
        self.corners = scene.tiles_at(t)
        self._tiles.set_corners(self.corners)
        pins = pins and len(scene.actuated_pins) > 0
        _show(self._pins_shown, pins)
        if pins:
            self._pins.set_corners(pin_prisms(scene.pins_at(t)))
        drawn = scene.membranes if membranes else ()
        _show(self._sheets_shown, bool(drawn))
        for sheet, membrane in zip(self._sheets, drawn):
            sheet.set_shape(scene.membrane_at(membrane, t), membrane.triangles)

    def mark(self, places: Mapping[str, np.ndarray]) -> None:
        """Draw marks by their shape at points (K x 3, mm)."""
        self._marks.removeAllChildren()
        add(self._marks, *(markers(shape, colours.MARK, points) for shape, points in places.items()))

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
        """Draw a scene at t, or both flat and, beside it, actuated; without marks."""
        both = both and scene.flat is not None
        self.t = 1.0 if scene.flat is None else 0.0 if both else t
        self._figure.draw(scene, self.t, pins, membranes)
        _show(self._beside_shown, both)
        if both:
            self._beside.draw(scene, 1.0, pins, membranes)
            self._beside.shift.translation = tuple(_shift(self._figure.corners, self._beside.corners))

    def colour(self, scene: Scene, colouring: Colouring, selected: Sequence[int], hovered: Sequence[int]
               ) -> None:
        """Colour tiles and membranes by values; selected and hovered tiles in FreeCAD's colours for them."""
        field = colouring.field
        if field is None or field.on == MEMBRANE:
            rgb = colouring.paled(np.broadcast_to(np.array(colours.PLAIN), (len(scene.F), 6, 3)))
        else:
            rgb = colouring.of(scene.slots(field))
        packed = colours.packed(rgb)
        packed[list(selected)] = _preferred("SelectionColor", (0.11, 0.68, 0.11))
        packed[list(hovered)] = _preferred("HighlightColor", (0.88, 0.88, 0.08))
        fill(self._tile_colours.orderedRGBA, packed.ravel())
        start = 0
        for node, membrane in zip(self._sheet_colours, scene.membranes):
            count = len(membrane.triangles)
            rgb = np.broadcast_to(np.array(colours.MEMBRANE), (count, 3))
            if field is not None and field.on == MEMBRANE:
                rgb = colouring.of(field.values[start : start + count])
            start += count
            fill(node.orderedRGBA, colours.packed(rgb))

    def mark(self, scene: Scene, fields: Iterable[Field]) -> None:
        """Mark the problems of fields by their shapes."""
        for figure in self._drawn():
            figure.mark({field.mark: scene.places(field, field.problems, figure.corners) for field in fields})

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


def _preferred(name: str, default: tuple[float, ...]) -> int:
    """A colour of the user's preferences, opaque and packed."""
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    return int(group.GetUnsigned(name, int(colours.packed(np.array(default)))) | 255)
