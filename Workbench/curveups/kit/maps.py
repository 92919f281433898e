# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings on the flat layout, at full size: the map of tiles with their numbers; where the surplus membrane
is cut off, along rims, holes and cuts; the frame in which parts of a print from several beds butt."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np
from matplotlib.figure import Figure

from ..base.language import Text
from ..report import pictures
from ..report.assembly import TRIM
from ..stages.cut_request import mesh_edges
from .beds import FIT
from .drawing import INCH, LAYERS, Drawing, draw, written, show_part
from .kit import Kit

LEAST_EDGE = 14.0  # mm of a tile on the map, so that its number can be read
LETTERS = 2.0      # mm
MAP_MARGIN = 8.0


def tile_map(kit: Kit) -> Drawing:
    """The front on the left, the back on the right; tiles of the weakest contacts on the layer cut."""
    corners = np.asarray(kit.results.design.T)
    edge = float(np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).mean())
    corners = corners * max(1.0, LEAST_EDGE / edge)
    low, high = corners.reshape(-1, 2).min(0), corners.reshape(-1, 2).max(0)
    width, height = map(float, high - low)
    size = (2 * width + 3 * MAP_MARGIN, height + 3 * MAP_MARGIN)
    drawing = Drawing(kit.say("{title}, tiles", title=kit.title), size)
    weak = {tile for contact in kit.report.get("worst_contacts", ()) for tile in contact["tiles"]}
    front = corners - low + MAP_MARGIN
    back = front * (-1, 1) + (2 * width + 3 * MAP_MARGIN, 0)
    drawing.text(MAP_MARGIN, height + 2.2 * MAP_MARGIN, 3.0,
                 kit.say("{title}: 12 is T00012", title=kit.title))
    for text, half, x in ((Text("front"), front, MAP_MARGIN),
                          (Text("back, mirrored"), back, width + 2 * MAP_MARGIN)):
        drawing.text(x, height + 1.5 * MAP_MARGIN, 3.0, kit.say(text))
        for tile, outline in enumerate(half):
            drawing.closed("cut" if tile in weak else "grid", outline)
            x, y = map(float, outline.mean(0))
            drawing.centred(x, y, LETTERS, str(tile + 1))
    return drawing


STOP = 1.0  # mm, radius of a hole that keeps a slit in the membrane from tearing on
MARGIN = 5.0
CORNER = 0.3  # of the distance; does for corners of up to 67 degrees
Edge = tuple[int, int]  # tile, edge


def trim_file(kit: Kit, kind: str) -> bytes:
    """The marks as pdf, svg or dxf."""
    return written(marks(kit), kind, [kit.say(_NOTE, trim=TRIM)], kit.go_on, kit.say)


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
    """Ends of cuts inside of the sheet: means of the corners that meet there."""
    F, T = np.asarray(design.F), np.asarray(design.T)
    ends, times = np.unique(np.asarray(design.cuts), return_counts=True)
    edges, sides = mesh_edges(F)
    rim = np.unique(edges[sides == 1])
    ends_inside = [T[F == vertex].mean(0) for vertex in ends[times == 1] if vertex not in rim]
    return np.array(ends_inside).reshape(-1, 2)


def trim_view(kit: Kit, width: float = 160.0) -> bytes:
    """The marks, and where they are on the shape, from two sides; as PNG so wide, mm."""
    drawing, design, colour = marks(kit), kit.results.design, LAYERS["cut"][0]
    scale = 0.5 * width / max(drawing.size)
    figure = Figure(figsize=(width / INCH, 0.55 * width / INCH))
    flat = figure.add_axes([0, 0.02, 0.5, 0.9])
    flat.set_title(kit.say("on the stretched sheet"))
    show_part(flat, (0, 0, *drawing.size))
    flat.set_aspect("equal")
    draw(flat, drawing, scale)
    rims = [(*edge, colour) for loop in boundary(kit.shapes, len(design.F)) for edge in loop]
    for bottom, turned, title in ((0.49, False, kit.say("on the shape, from two sides")), (0.02, True, "")):
        axes = figure.add_axes([0.52, bottom, 0.47, 0.43])
        axes.set_title(title)
        pictures._draw_actuated(axes, design, turned, lines=rims)
    return pictures._png(figure, 160)


_FRAME_NOTE = Text("""Parts of the print with their numbers, seen from above, the side that lies up on the
beds.""")
FRAME_EDGE = 15.0  # mm of the frame around its pocket


def frame_file(kit: Kit, kind: str) -> bytes:
    """The frame as dxf or pdf."""
    return written(frame(kit), kind, [kit.say(_FRAME_NOTE)], kit.go_on, kit.say)


def frame(kit: Kit) -> Drawing:
    """Layer cut: the frame and its pockets, one a piece. Layer control: the parts, as they lie in them; of
    parts without slabs, which hold by their bridges, their tiles and anchors."""
    assert kit.beds is not None
    pockets = [_grown(np.asarray(loops[0]), FIT) for loops in kit.model.outlines]
    model = kit.beds.model
    parts = [(f"{slab.piece + 1}", [np.asarray(loops[0])])
             for slab, loops in zip(model.bodies("support"), model.outlines)]
    if not parts:
        bodies = [(body.piece, outline) for kind in ("tiles", "anchors") if model.volumes[kind]
                  for body, outline in zip(model.bodies(kind), outlines_of(model, kind))]
        parts = [(f"{part + 1}", [outline for other, outline in bodies if other == part])
                 for part in sorted({part for part, _ in bodies})]
    lines = [*pockets, *(line for _, outlines in parts for line in outlines)]
    low = np.min([line.min(0) for line in lines], axis=0) - FRAME_EDGE
    size = np.max([line.max(0) for line in lines], axis=0) + FRAME_EDGE - low
    drawing = Drawing(kit.say("{title}, frame", title=kit.title), (float(size[0]), float(size[1])))
    if pockets:
        drawing.box("cut", 0, 0, float(size[0]), float(size[1]))
    for pocket in pockets:
        drawing.closed("cut", pocket - low)
    for name, outlines in parts:
        for line in outlines:
            drawing.closed("control", line - low)
        x, y = np.concatenate(outlines).mean(0) - low
        drawing.centred(float(x), float(y), 6.0, name)
    return drawing


def _grown(loop: np.ndarray, by: float) -> np.ndarray:
    """A counter-clockwise loop, each side moved outwards."""
    along = np.roll(loop, -1, axis=0) - loop
    along = along / np.linalg.norm(along, axis=1)[:, None]
    out = np.stack([along[:, 1], -along[:, 0]], axis=1)
    both = out + np.roll(out, 1, axis=0)
    return np.asarray(loop + 2 * by * both / np.maximum((both ** 2).sum(1), 1.0)[:, None])


def outlines_of(model: Any, kind: str) -> list[np.ndarray]:
    """Convex hull of each body of a native PrintModel as seen from above, n x 2, mm."""
    from scipy.spatial import ConvexHull  # which other commands would pay

    points, faces, body = model.mesh(kind)
    seen = (points[np.unique(faces[body == number])][:, :2] for number in np.unique(body))
    return [np.asarray(corners[ConvexHull(corners).vertices]) for corners in seen]
