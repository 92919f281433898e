# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is drawn, as Coin nodes: each kind of thing in one set of nodes, however many there are of it.

Arrays go over whole: one element at a time takes seconds.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from pivy import coin

from . import prisms
from .prisms import Topology

_ROOM_FOR_RIMS = 90.0  # px2 of the screen a prism; below, lines would drown its colours


def fill(field: Any, values: np.ndarray) -> None:
    """All values of a multiple-value field, and no others."""
    count = len(values)
    if values.dtype == np.uint32:  # pivy takes numbers of this kind faster, and in all versions, as a list
        values = values.tolist()
    elif values.dtype != np.int32:
        values = np.ascontiguousarray(values, np.float32)
    field.setNum(count)
    if count:
        field.setValues(0, count, values)


def add(group: Any, *parts: Any) -> None:
    """Nodes to a group, in their order."""
    for part in parts:
        group.addChild(part)


class Prisms:
    """Prisms with one colour for each of their slots, and their rims as lines."""

    def __init__(self, topology: Topology, colours: Any):
        """colours: a SoPackedColor, which several sets may share."""
        self._topology, self._count = topology, -1
        self.node = coin.SoSeparator()
        self.node.renderCaching = coin.SoSeparator.OFF  # what depends on the camera is never worth it
        self._corners, self._points = coin.SoCoordinate3(), coin.SoCoordinate3()
        self._normals, self._faces = coin.SoNormal(), coin.SoIndexedFaceSet()
        self._lines = coin.SoIndexedLineSet()
        hints = coin.SoShapeHints()
        hints.vertexOrdering, hints.faceType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.CONVEX
        hints.shapeType = coin.SoShapeHints.SOLID
        normals, materials = coin.SoNormalBinding(), coin.SoMaterialBinding()
        normals.value = coin.SoNormalBinding.PER_FACE_INDEXED
        materials.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        behind = coin.SoPolygonOffset()
        behind.factor = behind.units = 1.0
        faces, lines = coin.SoSeparator(), coin.SoSeparator()
        faces.renderCaching = lines.renderCaching = coin.SoSeparator.ON
        add(faces, hints, colours, self._points, self._normals, normals, materials, behind, self._faces)
        self._rims = coin.SoLevelOfDetail()
        add(lines, _flat_colour((0.15, 0.15, 0.15)), unpickable(), self._corners, self._lines)
        add(self._rims, lines, coin.SoInfo())
        # FreeCAD's actions of selection enter groups. They lack what a level of detail asks of an action,
        # which ends FreeCAD 1.1. They pass kits by.
        kit, contents = coin.SoWrapperKit(), coin.SoSeparator()
        contents.addChild(self._rims)
        kit.setPart("contents", contents)
        add(self.node, faces, kit)

    def set_corners(self, corners: np.ndarray) -> None:
        """M x 6 x 3, mm."""
        if len(corners) != self._count:
            self._set_count(len(corners))
        points = prisms.with_middles(corners) if self._topology.points == 8 else corners
        fill(self._points.point, points.reshape(-1, 3))
        fill(self._corners.point, corners.reshape(-1, 3))
        fill(self._normals.vector, prisms.normals(corners).reshape(-1, 3))

    def _set_count(self, count: int) -> None:
        # Coordinates first shrink, or faces would point beyond them.
        self._count = count
        for field in (self._faces.coordIndex, self._lines.coordIndex):
            field.setNum(0)
        fill(self._faces.coordIndex, self._topology.coordinate_index(count))
        fill(self._faces.normalIndex, self._topology.normal_index(count))
        fill(self._faces.materialIndex, self._topology.colour_index(count))
        fill(self._lines.coordIndex, prisms.line_index(count))
        self._rims.screenArea.setValue(_ROOM_FOR_RIMS * count)

    def prism_of(self, picked: Any) -> int:
        """Which prism a SoPickedPoint is on; -1 where it is of something else."""
        detail = picked.getDetail(self._faces)
        if detail is None or detail.getTypeId() != coin.SoFaceDetail.getClassTypeId():
            return -1
        return coin.cast(detail, "SoFaceDetail").getFaceIndex() // len(self._topology.polygons)


class Outlines:
    """Rims of chosen prisms, thick, over all else."""

    def __init__(self, width: float):
        self.node = coin.SoAnnotation()
        self._colour, style = coin.SoBaseColor(), coin.SoDrawStyle()
        style.lineWidth = width
        self._points, self._lines = coin.SoCoordinate3(), coin.SoIndexedLineSet()
        add(self.node, unpickable(), unlit(), self._colour, style, self._points, self._lines)

    def set_corners(self, corners: np.ndarray, colour: tuple[float, ...]) -> None:
        """M x 6 x 3, mm; none to show nothing."""
        self._lines.coordIndex.setNum(0)
        self._colour.rgb = tuple(colour[:3])
        fill(self._points.point, corners.reshape(-1, 3))
        fill(self._lines.coordIndex, prisms.line_index(len(corners)))


class Markers:
    """Marks of one shape at points, of the same size at any distance, on white discs: they are told from
    any colour below them."""

    SHAPES = {"cross": "CROSS_7_7", "triangle": "TRIANGLE_FILLED_7_7", "square": "SQUARE_FILLED_7_7",
              "diamond": "DIAMOND_LINE_7_7", "star": "STAR_7_7"}

    def __init__(self, shape: str, colour: tuple[float, float, float]):
        self.node = coin.SoSeparator()
        self._points, self._marks = coin.SoCoordinate3(), [coin.SoMarkerSet(), coin.SoMarkerSet()]
        disc, mark = self._marks
        disc.markerIndex = coin.SoMarkerSet.CIRCLE_FILLED_9_9
        mark.markerIndex = getattr(coin.SoMarkerSet, self.SHAPES[shape])
        depth = coin.SoDepthBuffer()
        depth.write = False  # otherwise the disc hides its mark, which is no nearer
        add(self.node, unpickable(), depth, self._points, _flat_colour((1, 1, 1)), disc,
            _flat_colour(colour), mark)

    def set_points(self, points: np.ndarray) -> None:
        """K x 3, mm."""
        fill(self._points.point, points)
        for marks in self._marks:
            marks.numPoints = len(points)


class Sheet:
    """A membrane: triangles with a colour each."""

    def __init__(self, colours: Any):
        """colours: a SoPackedColor, one a triangle."""
        self.node = coin.SoSeparator()
        self.node.renderCaching = coin.SoSeparator.ON
        self._points, self._faces = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        self._drawn: Optional[np.ndarray] = None
        hints, materials = coin.SoShapeHints(), coin.SoMaterialBinding()
        hints.vertexOrdering, hints.faceType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.CONVEX
        materials.value = coin.SoMaterialBinding.PER_FACE
        add(self.node, hints, unpickable(), colours, materials, self._points, self._faces)

    def set_shape(self, points: np.ndarray, triangles: np.ndarray) -> None:
        """P x 3 points (mm) and K x 3 numbers of them."""
        if triangles is not self._drawn:
            self._faces.coordIndex.setNum(0)
        fill(self._points.point, points)
        if triangles is not self._drawn:
            index = np.full((len(triangles), 4), -1, np.int32)
            index[:, :3] = triangles
            fill(self._faces.coordIndex, index.ravel())
            self._drawn = triangles


def _flat_colour(colour: tuple[float, float, float]) -> Any:
    group, base = coin.SoGroup(), coin.SoBaseColor()
    base.rgb = colour
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.OVERALL
    add(group, unlit(), base, binding)
    return group


def unlit() -> Any:
    """Colours as they are, whatever the light."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def unpickable() -> Any:
    """The mouse does not meet what follows."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style
