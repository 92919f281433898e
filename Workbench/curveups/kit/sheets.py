# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages of a kit besides the print: the shop's page, and a list of all sheets, templates, rings and the
former. files.py loads this module with its first kit, since it loads matplotlib."""

from __future__ import annotations

from functools import partial
from typing import Any, Callable, Sequence

from ..base.language import Text
from ..report.print_pictures import draw_prints
from ..report.shop import quote, rules
from . import assembly_sheet, latex, maps, ring_sheet
from .drawing import BORDER, PAPERS, book, sheet, svg, write
from .former import former_stl
from .kit import Kit

LABELS = 48.0  # mm, width of the column of labels
PICTURE = 45.0  # mm, height of the picture at the least
LINE, A_PAGE = 3.3, 75  # mm of a file's line, and how many a page has
MOST_REASONS = 3


def shop_page(kit: Kit) -> bytes:
    """A PDF, of one page where that has room for all."""
    width, height = PAPERS["A4"]
    figure, page = sheet(width, height)
    parameters, say = kit.results.parameters, kit.say
    top = write(page, BORDER, height - BORDER, [say("{title}: order for a 3D print", title=kit.title)], 15)
    said = (*_doubts(kit), *rules(kit.report, parameters, say))
    top = write(page, BORDER, top - 1, [f"•  {rule}" for rule in said], 9.5) - 1
    for label, value in quote(kit.report, parameters, kit.quantity, say, kit.whole):
        page.plot([BORDER, width - BORDER], [top - 0.4] * 2, color="#cccccc", linewidth=0.4)
        top = min(write(page, BORDER, top, [label], 8, LABELS - 2),
                  write(page, BORDER + LABELS, top, [value], 8))
    notes = [say(_FUSED)] if any("fused" in name for name in kit.files) else []
    top = write(page, BORDER, top - 1, notes, 8)
    figures, files = [figure], [f"{name}   {about['bytes']}   {about['sha256']}"
                                for name, about in kit.files.items()]
    if top - LINE * (len(files) + 2) - PICTURE > BORDER:
        top = _list(kit, page, top, files)
    else:
        top = write(page, BORDER, top, [say("The pages that follow list the files.")], 8)
        for first in range(0, len(files), A_PAGE):
            figures.append(sheet(width, height)[0])
            _list(kit, figures[-1].axes[0], height - BORDER, files[first:first + A_PAGE])
    axes = figure.add_axes([BORDER / width, BORDER / height, 1 - 2 * BORDER / width, (top - BORDER) / height])
    draw_prints(axes, kit.prints, kit.printer["bed_mm"], say)
    return book(iter(figures))


def _list(kit: Kit, page: Any, top: float, files: Sequence[str]) -> float:
    """Write the files down from `top`, mm. Return the end."""
    top = write(page, BORDER, top, [kit.say("Files, in mm, with bytes and SHA-256:")], 8)
    return write(page, BORDER, top, files, 5.5)


_FUSED = Text("""Where bodies must not overlap, there is the same as one closed shell a piece, with
fused in the name.""")


def _doubts(kit: Kit) -> list[str]:
    """Reasons not to print it; none where the design is valid."""
    if kit.report["valid"]:
        return []
    why = kit.say("Do not order it as it is: the design is not valid.") if kit.report["valid"] is False else \
        kit.say("Do not order it as it is: the design is not verified.")
    reasons = kit.results.verdict.reasons[:MOST_REASONS]
    return [why, *(reason.sentence(kit.say.style) for reason in reasons)]


Make = Callable[[], bytes]


def files(kit: Kit) -> dict[str, Make]:
    """Makers of sheets, by the names of their files. The order comes first: it lists the files before it."""
    sides = ("front", "back")
    makers: dict[str, Make] = {"shop.pdf": partial(shop_page, kit)}
    for side in sides:
        for kind in ("pdf", "svg", "dxf"):
            makers[f"latex-{side}.{kind}"] = partial(latex.make, kit, side, kind)
    for side in sides:
        for kind in ("step", "stl", "dxf"):
            makers[f"ring-{side}.{kind}"] = partial(ring_sheet.make, kit, side, kind)
    for kind in ("html", "pdf"):
        makers[f"assembly.{kind}"] = partial(assembly_sheet.make, kit, kind)
    makers["tiles.svg"] = lambda: svg(maps.tile_map(kit))
    for kind in ("pdf", "dxf", "svg"):
        makers[f"trim.{kind}"] = partial(maps.trim_file, kit, kind)
    makers["former.stl"] = partial(former_stl, kit.formers)
    if kit.beds is not None and kit.beds.seams:
        for kind in ("dxf", "pdf"):
            makers[f"frame.{kind}"] = partial(maps.frame_file, kit, kind)
    return {f"{kit.name}-{name}": make for name, make in makers.items()}
