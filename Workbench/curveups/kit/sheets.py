# SPDX-License-Identifier: LGPL-2.1-or-later
"""List of what a kit has besides the print: sheets, templates, rings and the former. files.py loads this
module with its first kit, since it loads matplotlib."""

from __future__ import annotations

from functools import partial
from typing import Callable

from . import assembly_sheet, frame, latex, ring_sheet, shop_sheet, tile_map, trim
from .former import former_stl
from .kit import Kit

Make = Callable[[], bytes]


def files(kit: Kit) -> dict[str, Make]:
    """Makers of sheets, by the names of their files. The order comes first: it lists the files before it."""
    sides = ("front", "back")
    made: dict[str, Make] = {"shop.pdf": partial(shop_sheet.make, kit)}
    for side in sides:
        for kind in ("pdf", "svg", "dxf"):
            made[f"latex-{side}.{kind}"] = partial(latex.make, kit, side, kind)
    for side in sides:
        for kind in ("step", "stl", "dxf"):
            made[f"ring-{side}.{kind}"] = partial(ring_sheet.make, kit, side, kind)
    for kind in ("html", "pdf"):
        made[f"assembly.{kind}"] = partial(assembly_sheet.make, kit, kind)
    made["tiles.svg"] = partial(tile_map.make, kit)
    for kind in ("pdf", "dxf", "svg"):
        made[f"trim.{kind}"] = partial(trim.make, kit, kind)
    made["former.stl"] = partial(former_stl, kit.formers)
    if kit.beds is not None and kit.beds.seams:
        for kind in ("dxf", "pdf"):
            made[f"frame.{kind}"] = partial(frame.make, kit, kind)
    return {f"{kit.name}-{name}": make for name, make in made.items()}
