# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ribs at full size, to be cut of a sheet, and the former as a body."""

from __future__ import annotations

from .drawing import Drawing, dxf, svg
from .kit import Kit
from .underside import SHEET

GAP = 6.0  # mm between ribs on the drawing


def make(kit: Kit, kind: str) -> bytes:
    """The ribs as dxf or svg."""
    return (svg if kind == "svg" else dxf)(ribs(kit))


def former(kit: Kit) -> bytes:
    """A closed body as binary STL."""
    return kit.underside.body()


def ribs(kit: Kit) -> Drawing:
    """Layer cut: closed outlines, one above the other; each has its name."""
    found = kit.underside.ribs
    width = max((rib.length for rib in found), default=0.0) + 2 * GAP
    height = GAP
    drawing = Drawing(f"{kit.title}, ribs of {SHEET:g} mm", (width, 0.0))
    for rib in found:
        outline = rib.outline() - [rib.x[0] - GAP, -height]
        drawing.line("cut", *outline)
        drawing.text(GAP + 1, height + 1, 3.0, rib.name)
        height += float(rib.top.max()) + GAP
    drawing.size = (width, height)
    return drawing
