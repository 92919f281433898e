# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the surplus membrane is cut off: along rims, holes and cuts, on the stretched sheet seen from the
front, at full size; and a picture of where that is on the shape."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np
from matplotlib.figure import Figure

from ..base.language import Text
from ..report import pictures
from ..report.assembly import TRIM
from .drawing import INCH, LAYERS, Drawing, draw, made
from .frame import outlines_of
from .kit import Kit

STOP = 1.0  # mm, radius of a hole that keeps a slit in the membrane from tearing on
MARGIN = 5.0
CORNER = 0.3  # of the distance; does for corners of up to 67 degrees
Edge = tuple[int, int]  # tile, edge


def make(kit: Kit, kind: str) -> bytes:
    """The marks as pdf, svg or dxf."""
    return made(marks(kit), kind, [kit.say(_NOTE, trim=TRIM)], kit.go_on, kit.say)


_NOTE = Text("""Seen from the front, at the size of the stretched sheet. Lay it on the front sheet before
that leaves its ring: the thin triangles are the outer pins, what stands around them are anchors.
Copy the thick red lines, {trim:g} mm outside of the pins, and cut along these once the shell is off
its rings. Where small circles lie on them, punch these first.""")


def marks(kit: Kit) -> Drawing:
    """Layer cut: closed lines and stop holes; grid: the outer pins; control: the anchors, to lay it on."""
    pins = kit.shapes.flat_pins[:, :, :3, :2]  # tiles, front and back, corners, x and y
    loops = list(boundary(kit.shapes, len(pins)))
    outlines = [_outline(pins, loop) for loop in loops]
    holes = _ends_of_cuts(kit.results.design)
    anchors = _anchors(kit)
    points = np.concatenate([*outlines, *anchors])
    low, high = points.min(0) - MARGIN, points.max(0) + MARGIN
    size = (float(high[0] - low[0]), float(high[1] - low[1]))
    drawing = Drawing(kit.say("{title}, trim", title=kit.title), size)
    for outline in outlines:
        drawing.closed("cut", outline - low)
    for x, y in holes:
        drawing.circle("cut", float(x - low[0]), float(y - low[1]), STOP)
    for tile in sorted({tile for loop in loops for tile, _ in loop}):
        drawing.closed("grid", pins[tile, 0] - low)
    for anchor in anchors:
        drawing.closed("control", anchor - low)
    return drawing


def _anchors(kit: Kit) -> list[np.ndarray]:
    """Outlines of anchors seen from the front."""
    if not kit.model.volumes["anchors"]:
        return []
    side = (1, 1) if kit.results.parameters.get("orientation") == "front-up" else (1, -1)
    tiles, anchors = ([outline * side for outline in outlines_of(kit.model, kind)]
                      for kind in ("tiles", "anchors"))
    shift = _middle(np.asarray(kit.shapes.flat)[..., :2].reshape(-1, 2)) - _middle(np.concatenate(tiles))
    return [outline + shift for outline in anchors]


def _middle(points: np.ndarray) -> np.ndarray:
    return np.asarray((points.min(0) + points.max(0)) / 2)


def boundary(shapes: Any, count: int) -> Iterator[list[Edge]]:
    """Edges of tiles that touch no other, in the order of their loops. shapes: native TileShapes."""
    across: dict[Edge, Edge] = {}
    for (a, b), (i, j) in zip(shapes.contacts.tolist(), shapes.contact_sides.tolist()):
        across[a, i], across[b, j] = (b, j), (a, i)
    open_edges = {(tile, edge) for tile in range(count) for edge in range(3)} - across.keys()
    while open_edges:
        here = start = min(open_edges)
        loop = []
        while True:
            loop.append(here)
            open_edges.discard(here)
            here = here[0], (here[1] + 1) % 3
            while here in across:  # around the vertex
                tile, edge = across[here]
                here = tile, (edge + 1) % 3
            if here == start:
                break
        yield loop


def _outline(pins: np.ndarray, loop: list[Edge]) -> np.ndarray:
    """Pin edges along a loop, moved outwards; halfway to what is nearer than two margins."""
    tiles, edges = np.array(loop).T
    ends = np.stack([pins[tiles, 0, edges], pins[tiles, 0, (edges + 1) % 3]], axis=1)
    along = ends[:, 1] - ends[:, 0]
    along = along / np.linalg.norm(along, axis=1)[:, None]
    out = np.stack([along[:, 1], -along[:, 0]], axis=1)
    # The back's pin may reach out further than the front's.
    further = np.einsum("nck,nk->nc", pins[tiles, 1] - ends[:, :1], out).max(1).clip(0)
    middle = ends.mean(1) + further[:, None] * out
    away = middle[None] - middle[:, None]
    distance = np.linalg.norm(away, axis=2)
    ahead = np.einsum("nmk,nk->nm", away, out) > 0.5 * np.maximum(distance, 1e-9)
    room = np.where(ahead, distance, np.inf).min(1)
    move = further + np.minimum(TRIM, 0.45 * room)
    # Ends are drawn out, so that the line keeps its distance around corners of the layout, too.
    drawn = CORNER * np.array([-1, 1])[None, :, None] * along[:, None]
    return np.asarray((ends + move[:, None, None] * (out[:, None] + drawn)).reshape(-1, 2))


def _ends_of_cuts(design: Any) -> np.ndarray:
    """Where cuts end inside of the sheet, by the mean of the corners that meet there."""
    cuts, F, T = np.asarray(design.cuts), np.asarray(design.F), np.asarray(design.T)
    ends, times = np.unique(cuts, return_counts=True)
    edges = np.sort(np.stack([F, np.roll(F, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges, sides = np.unique(edges, axis=0, return_counts=True)
    rim = np.unique(edges[sides == 1])
    found = [T[F == vertex].mean(0) for vertex in ends[times == 1] if vertex not in rim]
    return np.array(found).reshape(-1, 2)


def trim_view(kit: Kit, width: float = 160.0) -> bytes:
    """The marks, and where they are on the shape, from two sides; as PNG so wide, mm."""
    drawing, design, colour = marks(kit), kit.results.design, LAYERS["cut"][0]
    scale = 0.5 * width / max(drawing.size)
    figure = Figure(figsize=(width / INCH, 0.55 * width / INCH))
    flat = figure.add_axes([0, 0.02, 0.5, 0.9])
    flat.set_title(kit.say("on the stretched sheet"))
    flat.set_xlim(0, drawing.size[0])
    flat.set_ylim(0, drawing.size[1])
    flat.set_aspect("equal")
    flat.axis("off")
    draw(flat, drawing, scale)
    rims = [(*edge, colour) for loop in boundary(kit.shapes, len(design.F)) for edge in loop]
    for bottom, turned, title in ((0.49, False, kit.say("on the shape, from two sides")), (0.02, True, "")):
        axes = figure.add_axes([0.52, bottom, 0.47, 0.43])
        axes.set_title(title)
        pictures._draw_actuated(axes, design, turned, lines=rims)
    return pictures._png(figure, 160)
