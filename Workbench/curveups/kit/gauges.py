# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ribs at full size, to be cut of a sheet, and the former as a body; of each piece one beside the other."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from .drawing import Drawing, dxf, svg
from .kit import Kit
from .underside import SHEET, Underside, named

GAP = 6.0  # mm between ribs, and between formers


def make(kit: Kit, kind: str) -> bytes:
    """The ribs as dxf or svg."""
    return (svg if kind == "svg" else dxf)(ribs(kit))


def former(kit: Kit) -> bytes:
    """A closed body a piece as binary STL."""
    return former_stl(kit.undersides)


def former_stl(undersides: Sequence[Underside]) -> bytes:
    """Bodies side by side."""
    sizes = [under.size[0] + GAP for under in undersides]
    corners = np.concatenate([under.facets() + (float(sum(sizes[:number])), 0, 0)
                              for number, under in enumerate(undersides)])
    rows = np.zeros(len(corners), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("rest", "<u2")])
    rows["corners"] = corners
    return b"CurveUps former".ljust(80) + np.uint32(len(rows)).tobytes() + rows.tobytes()


def ribs(kit: Kit) -> Drawing:
    """Layer cut: closed outlines, one above the other; each has its name."""
    found = named(kit.undersides)
    width = max((rib.length for _, rib in found), default=0.0) + 2 * GAP
    height = GAP
    drawing = Drawing(kit.say("{title}, ribs of {sheet:g} mm", title=kit.title, sheet=SHEET), (width, 0.0))
    for name, rib in found:
        outline = rib.outline() - [rib.x[0] - GAP, -height]
        drawing.line("cut", *outline)
        drawing.text(GAP + 1, height + 1, 3.0, name)
        height += float(rib.top.max()) + GAP
    drawing.size = (width, height)
    return drawing
