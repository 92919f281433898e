# SPDX-License-Identifier: LGPL-2.1-or-later
"""The frame in which parts of a print from several beds butt."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..base.language import Text
from .beds import FIT
from .drawing import Drawing, made
from .kit import Kit

_NOTE = Text("""Parts of the print with their numbers, seen from above, the side that lies up on the
beds.""")
EDGE = 15.0  # mm of the frame around its pocket


def make(kit: Kit, kind: str) -> bytes:
    """The frame as dxf or pdf."""
    return made(frame(kit), kind, [kit.say(_NOTE)], kit.go_on, kit.say)


def frame(kit: Kit) -> Drawing:
    """Layer cut: the frame and its pockets, one a piece. Layer control: the parts, as they lie in them; of
    parts without slabs, which hold by their bridges, their tiles and anchors."""
    assert kit.beds is not None
    pockets = [_grown(np.asarray(loops[0]), FIT) for loops in kit.model.outlines]
    model = kit.beds.model
    parts = [(f"{part + 1}", [np.asarray(loops[0])])
             for part, loops in zip(model.piece_of_bodies("support"), model.outlines)]
    if not parts:
        bodies = [(part, outline) for kind in ("tiles", "anchors") if model.volumes[kind]
                  for part, outline in zip(model.piece_of_bodies(kind), outlines_of(model, kind))]
        parts = [(f"{part + 1}", [outline for other, outline in bodies if other == part])
                 for part in sorted({part for part, _ in bodies})]
    lines = [*pockets, *(line for _, found in parts for line in found)]
    low = np.min([line.min(0) for line in lines], axis=0) - EDGE
    size = np.max([line.max(0) for line in lines], axis=0) + EDGE - low
    drawing = Drawing(kit.say("{title}, frame", title=kit.title), (float(size[0]), float(size[1])))
    if pockets:
        drawing.box("cut", 0, 0, float(size[0]), float(size[1]))
    for pocket in pockets:
        drawing.closed("cut", pocket - low)
    for name, found in parts:
        for line in found:
            drawing.closed("control", line - low)
        x, y = np.concatenate(found).mean(0) - low
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
    """Of each body of a native PrintModel, seen from above: convex hulls, n x 2 mm."""
    points, faces, body = model.mesh(kind)
    return [_hull(points[np.unique(faces[body == one])][:, :2]) for one in np.unique(body)]


def _hull(points: np.ndarray) -> np.ndarray:
    from scipy.spatial import ConvexHull  # which other commands would pay

    return np.asarray(points[ConvexHull(points).vertices])
