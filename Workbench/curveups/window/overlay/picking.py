# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the mouse is on the tiles, down to the edge: for tools that pick edges.

    pick(view, position, design) -> Pick or None

`view`: a 3D view (`FreeCADGui.ActiveDocument.ActiveView`); `position`: pixels from its lower left
corner, as FreeCAD's event callbacks have it in event["Position"].
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import FreeCAD
import numpy as np
from pivy import coin

from ..overlays import overlay_of
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
