# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the mouse is on the tiles, down to the edge, and lines along edges: for tools that pick edges.

    pick(view, position, design) -> Pick or None

`view`: a 3D view (`FreeCADGui.ActiveDocument.ActiveView`); `position`: pixels from its lower left
corner, as FreeCAD's event callbacks have it in event["Position"].
"""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence

import FreeCAD
import numpy as np
from pivy import coin

from ...stages.cut_request import sides_of_edges
from ..overlays import overlay_of
from ..qt import QtCore
from .cameras import views_of
from .nodes import add, fill, unlit, unpickable
from .overlay import Overlay


@dataclass(frozen=True)
class Pick:
    """`tile`: row of F. `edge`: 0 to 2, the nearest edge of that tile, from its corner `edge` to the next
    one. `vertices`: those of the mesh that it joins. `point`: on the tile as it is drawn, mm. `ends`:
    the edge as it is drawn in front, 2 x 3 mm. `overlay`: of the design it belongs to."""

    overlay: Overlay
    tile: int
    edge: int
    vertices: tuple[int, int]
    point: np.ndarray
    ends: np.ndarray


def pick(view: Any, position: Sequence[float], design: Any) -> Optional[Pick]:
    """The nearest tile of a Design below a position; None beside them, and where it is not shown."""
    overlay = overlay_of(design)
    if not overlay.visible():
        return None
    start, along = ray(view, position)
    best, nearest = None, np.inf
    place = overlay.placement().inverse()
    origin = np.array(place.multVec(FreeCAD.Vector(*start)))
    towards = np.array(place.Rotation.multVec(FreeCAD.Vector(*along)))
    for corners, shift in overlay.figures():
        tile, distance = nearest_tile(corners, origin - shift, towards)
        if tile >= 0 and distance < nearest:
            point = origin + distance * towards
            nearest, best = distance, _on_tile(overlay, tile, corners, shift, point, place.inverse())
    return best


def ray(view: Any, position: Sequence[float]) -> tuple[np.ndarray, np.ndarray]:
    """Start (mm) and direction (unit) of the line of sight through a pixel."""
    region = view.getViewer().getSoRenderManager().getViewportRegion()
    width, height = region.getViewportSizePixels()
    aspect = width / height
    volume = view.getCameraNode().getViewVolume(aspect)
    if aspect < 1:  # as the viewer does it for tall windows
        volume.scale(1 / aspect)
    near, far = volume.projectPointToLine(coin.SbVec2f(position[0] / width, position[1] / height))
    start, end = np.array(near.getValue()), np.array(far.getValue())
    return start, (end - start) / np.linalg.norm(end - start)


def nearest_tile(corners: np.ndarray, start: np.ndarray, along: np.ndarray) -> tuple[int, float]:
    """The prism (of M x 6 x 3) that a ray enters first, and where; -1 where it meets none."""
    found = np.full(len(corners), np.inf)
    for triangle in ((0, 1, 2), (5, 4, 3), (1, 0, 3), (1, 3, 4), (2, 1, 4), (2, 4, 5), (0, 2, 5), (0, 5, 3)):
        a, b, c = (corners[:, k] for k in triangle)
        u, v = b - a, c - a
        normal = np.cross(along, v)
        det = np.einsum("mk,mk->m", u, normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            off = start - a
            s = np.einsum("mk,mk->m", off, normal) / det
            turned = np.cross(off, u)
            r = turned @ along / det
            distance = np.einsum("mk,mk->m", v, turned) / det
            inside = (s >= 0) & (r >= 0) & (s + r <= 1) & (distance >= 0)
        found = np.where(inside & (distance < found), distance, found)
    if not len(found) or not np.isfinite(found.min()):
        return -1, np.inf
    tile = int(np.argmin(found))
    return tile, float(found[tile])


def _on_tile(overlay: Overlay, tile: int, corners: np.ndarray, shift: np.ndarray, point: np.ndarray,
             place: Any) -> Pick:
    assert overlay.scene is not None
    front = corners[tile, :3] + shift
    ends = np.stack([front, np.roll(front, -1, axis=0)], axis=1)
    along = ends[:, 1] - ends[:, 0]
    share = np.einsum("ek,ek->e", point - ends[:, 0], along) / np.einsum("ek,ek->e", along, along)
    share = np.clip(share, 0, 1)
    edge = int(np.argmin(np.linalg.norm(ends[:, 0] + share[:, None] * along - point, axis=1)))
    a, b = (int(overlay.scene.F[tile, k]) for k in (edge, (edge + 1) % 3))
    world = [np.array(place.multVec(FreeCAD.Vector(*p))) for p in (point, *ends[edge])]
    return Pick(overlay, tile, edge, (a, b), world[0], np.array(world[1:]))


_SECONDS_BETWEEN_LOOKS = 0.03


class PickTool:
    """hover: gets a Pick or None as the mouse moves. click: gets a Pick; beside the tiles, and to turn or
    move the view, the mouse stays FreeCAD's. escape: answers whether Escape was of use."""

    def __init__(self, design: Any, hover: Callable[[Optional[Pick]], None], click: Callable[[Pick], None],
                 escape: Callable[[], bool]):
        self._design = design
        self._hover, self._click, self._escape = hover, click, escape
        self._looked, self._pressed = 0.0, False
        self._filters = [_Filter(view, self._takes) for view in views_of(design.Document.Name)]

    def close(self) -> None:
        """The mouse is FreeCAD's again."""
        for one in self._filters:
            one.close()

    def _takes(self, view: Any, event: Any) -> bool:
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove and not event.buttons():
            now = time.perf_counter()
            if now - self._looked >= _SECONDS_BETWEEN_LOOKS:
                self._looked = now
                self._hover(self._find(view, event))
        elif kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            self._pressed = event.button() == QtCore.Qt.LeftButton and self._find(view, event) is not None
            return self._pressed
        elif kind == QtCore.QEvent.MouseButtonRelease and self._pressed:
            self._pressed = False
            found = self._find(view, event)
            if found is not None:
                self._click(found)
            return True
        elif kind == QtCore.QEvent.KeyPress and event.key() == QtCore.Qt.Key_Escape:
            return self._escape()
        return False

    def _find(self, view: Any, event: Any) -> Optional[Pick]:
        """At the event's place, in pixels of the screen from the view's lower left corner."""
        area = view.graphicsView().viewport()
        place = event.position() if hasattr(event, "position") else event.pos()
        ratio = area.devicePixelRatioF()
        return pick(view, (place.x() * ratio, (area.height() - 1 - place.y()) * ratio), self._design)


class _Filter(QtCore.QObject):
    """Sees the events of a view before FreeCAD does. takes: whether FreeCAD does not get one."""

    def __init__(self, view: Any, takes: Callable[[Any, Any], bool]):
        super().__init__()
        self._view, self._takes = view, takes
        self._widgets = view.graphicsView().viewport(), view.graphicsView()  # mouse, keys
        for widget in self._widgets:
            widget.installEventFilter(self)

    def close(self) -> None:
        """Sees no more events."""
        with suppress(RuntimeError):  # the view is gone
            for widget in self._widgets:
                widget.removeEventFilter(self)

    def eventFilter(self, widget: Any, event: Any) -> bool:
        # PySide2 may hand over a deleted object that had the event's address.
        try:
            return isinstance(event, QtCore.QEvent) and self._takes(self._view, event)
        except (RuntimeError, ReferenceError):  # a view or a design is going
            return False


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
        add(self.node, unpickable(), unlit())
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
        add(part, shade, style, points, lines)
        self.node.addChild(part)
        points.point.setNum(0)
        lines.numVertices.setNum(0)
        return points, lines
