# SPDX-License-Identifier: LGPL-2.1-or-later
"""The coupons' files: their bodies, the template of the strips of latex, the sheet that says how each is
measured, and MEASURED.json to be filled in."""

from __future__ import annotations

import math
from functools import partial
from typing import Any, Callable, Iterator, Mapping

import numpy as np
from matplotlib.figure import Figure

from ..base.language import Text
from ..base.native import native
from ..report.assembly import glue_asked
from ..report.data import to_text
from ..report.print_pictures import draw_print
from . import drawing
from .beds import turned
from .coupons import (FOOT_ANGLE, GRIP, NARROW, PIN, SIDE, WIDE, Coupon, measured, pull, sliding, stretches,
                      wanted)
from .drawing import BORDER, PAPERS, Drawing
from .kit import Kit

ROW = 8.0     # mm, of tables that are filled in by hand
COLUMN = 38.0
BOARD, RAISED = 60.0, 12.0  # mm and degrees, of the sketch of what slides
SPACE = 10.0  # mm around the strips


def files(kit: Kit) -> dict[str, Callable[[], bytes]]:
    """What makes each file, by its name."""
    parameters, say, found = kit.results.parameters, kit.say, {}
    for coupon in wanted(parameters):
        for ending in ("step", "3mf"):
            found[f"{kit.name}-{coupon.name}.{ending}"] = partial(_body, kit, coupon, ending, "print")
        for kind in ("tiles", "support"):
            if kind == "tiles" or (coupon.tiny and native.support_kind(parameters).bodies):
                found[f"{kit.name}-{coupon.name}-{kind}.stl"] = partial(_body, kit, coupon, "stl", kind)
    strips = latex_strips(kit)
    notes = [say("Cut both strips along the outer lines. Bars clamp them from the inner lines outwards.")]
    return {**found,
            **{f"{kit.name}-strips.{kind}": partial(drawing.made, strips, kind, notes, kit.go_on, say)
               for kind in ("pdf", "svg", "dxf")},
            f"{kit.name}-coupons.pdf": lambda: sheet(kit),
            f"{kit.name}-MEASURED.json": lambda: to_text(measured(parameters)).encode()}


def _body(kit: Kit, coupon: Coupon, ending: str, kind: str) -> bytes:
    return kit.written(_model(kit, coupon), ending, kind)


def _model(kit: Kit, coupon: Coupon) -> Any:
    if coupon.name not in kit.coupons:
        kit.coupons[coupon.name] = coupon.model(kit.results.parameters)
    return kit.coupons[coupon.name]


def latex_strips(kit: Kit) -> Drawing:
    """Layer cut: outlines; layer control: where bars end."""
    width = NARROW[0] + WIDE[0] + 3 * SPACE
    height = max(length + 2 * GRIP for _, length in (NARROW, WIDE)) + 2 * SPACE
    found, x = Drawing(kit.say("{title}, strips of latex", title=kit.title), (width, height)), SPACE
    for across, length in (NARROW, WIDE):
        found.box("cut", x, SPACE, across, length + 2 * GRIP)
        for y in (SPACE + GRIP, SPACE + GRIP + length):
            found.line("control", (x, y), (x + across, y))
        found.text(x + 1, SPACE + 1, 2.5, f"{across:g} × {length:g}")
        x += across + SPACE
    return found


def said(kit: Kit, coupon: Coupon) -> str:
    """How it is measured, with the numbers of this design."""
    parameters, say = kit.results.parameters, kit.say
    own = "" if coupon.own(parameters) else \
        say("The design has other walls: leave these slopes out of MEASURED.json.")
    shear = glue_asked(kit.report)
    asked = say("The design asks for {shear:.2f} MPa where its pins or anchors carry most: a glue that holds "
                "less is not for it.", shear=shear) if shear else ""
    peels = kit.report.get("glue", {}).get("peel_max_n_per_mm")
    peel = say("The membrane peels with up to {peel:.2f} N/mm.", peel=peels) if peels is not None else ""
    reach = stretches(parameters)
    lengths = {name: ", ".join(f"{stretch * size:g}" for stretch in reach)
               for name, size in (("lengths", NARROW[1]), ("wide_lengths", WIDE[1]))}
    return say(coupon.text, angle=FOOT_ANGLE, own=own, pin=PIN, side=SIDE, asked=asked, peel=peel,
               tau=parameters.get("tau"), **lengths, **pull(parameters))


_COVER = (
    Text("""Print the coupons before the design is ordered, as it will be printed: on the same printer, of the
same materials, the same way up. STEP and 3MF have all bodies in place, STL has tiles and support apart."""),
    Text("""You need a calliper, feeler gauges of 0.05 to 0.6 mm, a board, an inclinometer, thread, eight
bolts of M4 with nuts, a spring scale up to {scale} N, and latex of the same sheet for the strips
({name}-strips.pdf) and the glue's coupon."""),
    Text("""Each page says how one coupon is measured, and has a table for what you read. Then put the
readings into {name}-MEASURED.json, in place of null, in the units of the names. What stays null is left
out. Give three readings of a list or more, or none."""),
    Text("""“curveups calibrate {name}-MEASURED.json -o DIR” fits modulus, friction, glue and growth with
their uncertainty. It writes material.json and printer.json, which “curveups design --config” takes: with them
make the design and its kit anew. It prints other values, too, for you to read: no parameter of a design takes
the constants of Mooney-Rivlin, what creep leaves of the force, what peels glue, what gaps lose or what breaks
bridges."""))


def sheet(kit: Kit) -> bytes:
    """A cover, and a page a coupon."""
    parameters = kit.results.parameters

    def pages() -> Iterator[Figure]:
        found = wanted(parameters)
        figure, page = drawing.sheet(*PAPERS["A4"])
        top = drawing.write(page, BORDER, PAPERS["A4"][1] - BORDER, [
            kit.say("{title}: coupons", title=kit.title)], 17) - 2
        scale = math.ceil(1.5 * pull(parameters)["wide"] / 10) * 10
        drawing.write(page, BORDER, top, [kit.say(text, name=kit.name, scale=scale) for text in _COVER]
                      + [f"•  {kit.say(one.title)}: {kit.name}-{one.name}.step" for one in found], 11)
        yield figure
        for coupon in found:
            yield _page(kit, coupon)

    return drawing.book(pages(), kit.go_on)


def _page(kit: Kit, coupon: Coupon) -> Figure:
    (width, height), parameters = PAPERS["A4"], kit.results.parameters
    figure, page = drawing.sheet(width, height)
    top = drawing.write(page, BORDER, height - BORDER, [kit.say(coupon.title)], 17) - 2
    top = drawing.write(page, BORDER, top, [said(kit, coupon)], 11) - 2
    low = BORDER
    for name, rows in coupon.rows(parameters).items():
        if isinstance(rows, list):
            low = _table(page, low, name, rows) + ROW
        else:
            low = _table(page, low, "", [{name: rows}]) + ROW / 2
    sketch = coupon.name.startswith("friction")
    if sketch:
        _slope(page, low + ROW)
        low += BOARD
    axes = figure.add_axes([BORDER / width, low / height, 1 - 2 * BORDER / width, (top - low) / height])
    draw_print(axes, _model(kit, coupon), say=kit.say)
    return figure


def _slope(page: Any, low: float) -> None:
    """Both tiles on the board, when the upper one begins to slide."""
    V, F = sliding()
    tiles = V[F][:, :, :2] @ turned(180 - FOOT_ANGLE).T + (0.75 * BOARD, 0)
    board = np.array([(0, 0), (BOARD, 0), (BOARD, -2), (0, -2)])
    for points, colour in ((board, "#d9cfb8"), *((corners, "#3a6ea5") for corners in tiles)):
        x, y = turned(-RAISED) @ points.T
        page.fill(x + (PAPERS["A4"][0] - BOARD) / 2, y + low + 0.3 * BOARD, facecolor=colour,
                  edgecolor="black", linewidth=0.5)


def _table(page: Any, low: float, name: str, rows: list[Mapping[str, Any]]) -> float:
    """From `low` up; a column a reading, since there are few. Returns where it ends."""
    fields = list(rows[0])
    wide = (page.get_xlim()[1] - 2 * BORDER - COLUMN) / max(6, len(rows))
    for line, field in enumerate(reversed(fields)):
        y = low + line * ROW
        page.text(BORDER, y + 0.3 * ROW, f"{name}: {field}" if name else field, size=9)
        for k, row in enumerate(rows):
            x = BORDER + COLUMN + k * wide
            page.plot([x, x + wide, x + wide, x, x], [y, y, y + ROW, y + ROW, y], color="black",
                      linewidth=0.5)
            if row[field] is not None:
                page.text(x + wide / 2, y + 0.3 * ROW, f"{row[field]:.4g}", size=9, ha="center")
    return low + len(fields) * ROW
