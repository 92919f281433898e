# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ribs at full size, to be cut of a sheet; those of each piece above the other's."""

from __future__ import annotations

from .drawing import Drawing, made
from .kit import Kit
from .underside import SHEET, named

GAP = 6.0  # mm between ribs


def make(kit: Kit, kind: str) -> bytes:
    """The ribs as dxf or svg."""
    return made(ribs(kit), kind)


def ribs(kit: Kit) -> Drawing:
    """Layer cut: closed outlines, one above the other; each has its name."""
    found = named(kit.undersides)
    width = max((rib.length for _, rib in found), default=0.0) + 2 * GAP
    height = GAP
    drawing = Drawing(kit.say("{title}, ribs of {sheet:g} mm", title=kit.title, sheet=SHEET), (width, 0.0))
    for name, rib in found:
        outline = rib.outline() - [rib.x[0] - GAP, -height]
        drawing.line("cut", *outline)
        left, right = rib.foot()
        drawing.fitted(left - rib.x[0] + GAP + 1, height + 1, 3.0, name, right - left - 2)
        height += float(rib.top.max()) + GAP
    drawing.size = (width, height)
    return drawing
