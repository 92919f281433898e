# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes of the overlay: one set of nodes for each kind of thing, whatever their count.

Arrays are set as a whole: one element at a time takes seconds.
"""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from pivy import coin

from . import prisms
from .prisms import Topology

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
        normals, materials = coin.SoNormalBinding(), coin.SoMaterialBinding()
        normals.value = coin.SoNormalBinding.PER_FACE_INDEXED
        materials.value = coin.SoMaterialBinding.PER_FACE_INDEXED
        behind = coin.SoPolygonOffset()
        behind.factor = behind.units = 1.0
        faces = separator(hints, colours, self._points, self._normals, normals, materials, behind,
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
        points = prisms.with_middles(corners) if self._topology.points == 8 else corners
        fill(self._points.point, points.reshape(-1, 3))
        fill(self._corners.point, corners.reshape(-1, 3))
        fill(self._normals.vector, prisms.normals(corners).reshape(-1, 3))

    def _set_count(self, count: int) -> None:
        # Indices go first, or faces would point beyond fewer coordinates.
        self._count = count
        for field in (self._faces.coordIndex, self._lines.coordIndex):
            field.setNum(0)
        fill(self._faces.coordIndex, self._topology.coordinate_index(count))
        fill(self._faces.normalIndex, self._topology.normal_index(count))
        fill(self._faces.materialIndex, self._topology.colour_index(count))
        fill(self._lines.coordIndex, prisms.line_index(count))
        self._rims.screenArea.setValue(_AREA_WITH_RIMS * count)

    def prism_of(self, picked: Any) -> int:
        """Number of the prism at a SoPickedPoint; -1 if that is on something else."""
        detail = picked.getDetail(self._faces)
        if detail is None or detail.getTypeId() != coin.SoFaceDetail.getClassTypeId():
            return -1
        return coin.cast(detail, "SoFaceDetail").getFaceIndex() // len(self._topology.polygons)


class Outlines:
    """Rims of chosen prisms as thick lines over all else."""

    def __init__(self, width: float):
        self.node = coin.SoAnnotation()
        self._colour, self._points = coloured((0, 0, 0)), coin.SoCoordinate3()
        self._lines = coin.SoIndexedLineSet()
        add(self.node, unpickable(), unlit(), self._colour, lines_of(width), self._points, self._lines)

    def set_corners(self, corners: np.ndarray, colour: tuple[float, ...]) -> None:
        """Outline prisms with these corners, M x 6 x 3, mm."""
        self._lines.coordIndex.setNum(0)
        self._colour.rgb = tuple(colour[:3])
        fill(self._points.point, corners.reshape(-1, 3))
        fill(self._lines.coordIndex, prisms.line_index(len(corners)))


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
