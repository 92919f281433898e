# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools that pick edges of tiles by the mouse, and lines along edges."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence

import FreeCAD
import numpy as np
from pivy import coin

from ...stages.cut_request import sides_of_edges
from ..overlays import overlay_of, tile_in
from .overlay import Overlay
from .picture import coloured, fill, lines_of, separator, unlit, unpickable
from .showing import views_of

_PAUSE = 0.03  # s between two picks while the mouse moves


@dataclass(frozen=True)
class Pick:
    """A point on a tile, as drawn, mm, and the edge of that tile that is nearest to it. `vertices`: its ends
    in the mesh. `ends`: the edge as it is drawn in front, 2 x 3 mm."""

    vertices: tuple[int, int]
    point: np.ndarray
    ends: np.ndarray


def pick(view: Any, position: Sequence[float], design: Any) -> Optional[Pick]:
    """The nearest tile of a Design below a pixel of a 3D view, counted from the view's lower left corner.
    None if there is none."""
    overlay, info = overlay_of(design), view.getObjectInfo(tuple(int(round(x)) for x in position))
    if not info or info["Object"] != design.Name or info["Document"] != design.Document.Name:
        return None
    tile = tile_in(info["Component"])
    if tile < 0 or overlay.scene is None:
        return None
    return _on_tile(overlay, tile, np.array([info["x"], info["y"], info["z"]]))


def _on_tile(overlay: Overlay, tile: int, world: np.ndarray) -> Pick:
    placement = overlay.placement()
    point = np.array(placement.inverse().multVec(FreeCAD.Vector(*map(float, world))))
    # Two figures stand side by side: the point is on the nearer one.
    front = min((corners[tile, :3] + shift for corners, shift in overlay.figures()),
                key=lambda corners: np.linalg.norm(corners.mean(0) - point))
    ends = np.stack([front, np.roll(front, -1, axis=0)], axis=1)
    along = ends[:, 1] - ends[:, 0]
    share = np.einsum("ek,ek->e", point - ends[:, 0], along) / np.einsum("ek,ek->e", along, along)
    nearest = ends[:, 0] + np.clip(share, 0, 1)[:, None] * along
    edge = int(np.argmin(np.linalg.norm(nearest - point, axis=1)))
    a, b = (int(overlay.scene.F[tile, k]) for k in (edge, (edge + 1) % 3))  # type: ignore[union-attr]
    drawn = np.array([placement.multVec(FreeCAD.Vector(*map(float, end))) for end in ends[edge]])
    return Pick((a, b), world, drawn)


class PickTool:
    """Mouse on the tiles of a design, in all its views; FreeCAD selects nothing meanwhile.

    hover: gets a Pick or None as the mouse moves. click: gets a Pick. escape: ends what was begun."""

    def __init__(self, design: Any, hover: Callable[[Optional[Pick]], None], click: Callable[[Pick], None],
                 escape: Callable[[], object]):
        self._design, self._document = design, design.Document.Name
        self._hover, self._click, self._escape = hover, click, escape
        self._hovered, self._pressed = 0.0, False
        reactions = {"SoLocation2Event": self._move, "SoMouseButtonEvent": self._press,
                     "SoKeyboardEvent": self._key}
        self._callbacks = [
            (view, kind, view.addEventCallback(kind, partial(react, view)))
            for view in views_of(design.Document.Name) for kind, react in reactions.items()]
        self._let_select("FALSE")

    def close(self) -> None:
        """Give the mouse back to FreeCAD. The views of a closed document are gone: a touch would crash it."""
        if not views_of(self._document):
            return
        self._let_select("TRUE")
        for view, kind, callback in self._callbacks:
            with suppress(RuntimeError):  # the view is gone
                view.removeEventCallback(kind, callback)

    def _let_select(self, on: str) -> None:
        """Let FreeCAD select what is clicked, or not."""
        for view, *_ in self._callbacks:
            with suppress(RuntimeError):
                graph = view.getSceneGraph()
                # Its names before and since FreeCAD 1.1.
                (graph.getField("selectionRole") or graph.getField("selectionEnabled")).set(on)

    def _move(self, view: Any, event: Any) -> None:
        now = time.perf_counter()
        if now - self._hovered >= _PAUSE:
            self._hovered = now
            self._hover(pick(view, event["Position"], self._design))

    def _press(self, view: Any, event: Any) -> None:
        if event["Button"] != "BUTTON1":
            return
        picked, clicked = pick(view, event["Position"], self._design), self._pressed
        self._pressed = picked is not None and event["State"] == "DOWN"
        if clicked and picked is not None and event["State"] == "UP":
            self._click(picked)

    def _key(self, view: Any, event: Any) -> None:
        if event["Key"] == "ESCAPE" and event["State"] == "DOWN":
            self._escape()


# Colours differ in lightness as well as in hue.
_STYLES = {"cut": ((0.0, 0.0, 0.0), 5.0), "selected": ((0.90, 0.62, 0.0), 7.0),
           "hovered": ((0.34, 0.71, 0.91), 6.0), "suggested": ((0.84, 0.37, 0.0), 4.0)}


class CutLines:
    """Lines along edges, added to an Overlay until they are closed."""

    def __init__(self, overlay: Any):
        self._overlay = overlay
        self._F: Any = None
        self._sides: dict[tuple[int, int], list[tuple[int, int]]] = {}
        self.node = separator(unpickable(), unlit())
        self._lines = {kind: self._add_lines(*style) for kind, style in _STYLES.items()}
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
        for kind, (points, lines) in self._lines.items():
            sides = [side for a, b in kinds.get(kind, ())
                     for side in self._sides.get((min(a, b), max(a, b)), ())]
            tile, k = np.array(sides, int).reshape(-1, 2).T
            ends = np.concatenate([
                (np.stack([corners[tile, k], corners[tile, (k + 1) % 3]], axis=1) + shift).reshape(-1, 3)
                for corners, shift in self._overlay.figures()])
            lines.numVertices.setNum(0)
            fill(points.point, ends)
            fill(lines.numVertices, np.full(len(ends) // 2, 2, np.int32))

    def _add_lines(self, colour: tuple, width: float) -> tuple[Any, Any]:
        points, lines = coin.SoCoordinate3(), coin.SoLineSet()
        self.node.addChild(separator(coloured(colour), lines_of(width), points, lines))
        points.point.setNum(0)
        lines.numVertices.setNum(0)
        return points, lines
