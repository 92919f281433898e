# SPDX-License-Identifier: LGPL-2.1-or-later
"""Templates by which sheets of latex are cut and marked, at full size, before they are stretched."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from ..base.language import ENGLISH, Language, Text
from ..report.assembly import HOLE
from .drawing import CAPITALS, POINT, Drawing, written, wrapped
from .kit import Kit

EDGE = 8.0     # mm of paper around the cutting line, which crosses lie beside
LETTERS = 2.0  # mm


def make(kit: Kit, side: str, kind: str) -> bytes:
    """The template of a side as pdf, svg or dxf."""
    block = kit.report["sheets"]
    say = kit.say
    drawing = template(say("{title}, {side} sheet", title=kit.title, side=say(side)), block, say=say)
    return written(drawing, kind, _notes(say, side, block), kit.go_on, say)


def template(title: str, block: Mapping[str, Any], stretched: bool = False, say: Language = ENGLISH
             ) -> Drawing:
    """The cutting line, the grid, the crossings that come to teeth and five control squares; `stretched`: as
    it looks on the ring, without the grip, with the window and the box of what is glued."""
    scale = block["tau"] if stretched else 1.0
    edge = EDGE * scale
    cut = np.array(block["marked_mm" if stretched else "cut_mm"]) * scale
    marked, step = np.array(block["marked_mm"]) * scale, block["grid_mm"] * scale
    drawing = Drawing(title, (float(cut[0]) + 2 * edge, float(cut[1]) + 2 * edge))
    low = edge + (cut - marked) / 2
    drawing.box("cut", edge, edge, *map(float, cut))
    counts = np.rint(marked / step).astype(int)
    for column in range(counts[0] + 1):
        x = low[0] + column * step
        drawing.line("grid", (x, low[1]), (x, low[1] + marked[1]))
    for row in range(counts[1] + 1):
        y = low[1] + row * step
        drawing.line("grid", (low[0], y), (low[0] + marked[0], y))
    rows = block["tooth_rows"]
    for column in range(counts[0] + 1):
        for row in range(counts[1] + 1):
            if min(column, row, counts[0] - column, counts[1] - row) < rows:
                drawing.circle("control", low[0] + column * step, low[1] + row * step, HOLE / 2 * step)
    square, middle = block["control_square_mm"] * scale, low + marked / 2
    reach = marked / 2 - (rows + 1) * step - square / 2
    for u, v in ((0, 0), (-1, -1), (1, -1), (-1, 1), (1, 1)):
        x, y = middle + reach * (u, v) - square / 2
        drawing.box("control", x, y, square, square)
    if stretched:
        for name, size in ((say("window of the ring"), block["window_mm"]),
                           (say("box of the print"), block["box_mm"])):
            x, y = middle - np.array(size) / 2
            drawing.box("cut", float(x), float(y), *size)
            drawing.text(float(x) + 2, float(y) + 2, LETTERS * scale, name)
        return drawing
    words = say("{title}: cut {x:.0f} x {y:.0f} mm along the outer line, of which the outer {grip:g} mm are "
                "grip. Grid {grid:.4g} mm, stretched {pitch:g} mm; circles are holes for teeth. Squares "
                "{square:g} mm must read {stretched:g} mm when stretched, also just before gluing (creep).",
                title=title, x=cut[0], y=cut[1], **_sizes(block))
    for number, text in enumerate(wrapped(words, float(cut[0]) - 6, LETTERS * POINT / CAPITALS)):
        drawing.text(edge + 3, edge + 14 - 1.8 * LETTERS * number, LETTERS, text)
    return drawing


def _sizes(block: Mapping[str, Any]) -> dict[str, float]:
    return {"grip": block["grip_mm"], "grid": block["grid_mm"], "pitch": block["tooth_pitch_mm"],
            "square": block["control_square_mm"], "stretched": block["control_square_stretched_mm"],
            "tau": block["tau"], "hole": HOLE * block["grid_mm"]}


def _notes(say: Language, side: str, block: Mapping[str, Any]) -> list[str]:
    cut, thickness = block["cut_mm"], block["thickness_mm"][0 if side == "front" else 1]
    load = block["load_n"][side]
    return [say(note, x=cut[0], y=cut[1], thickness=thickness, load=load, **_sizes(block)) for note in _NOTES]


_NOTES = (
    Text("""Latex {thickness:g} mm thick. Wash it, dry it, pull it to some {tau:g} times its size and let it
go, twice. Then trace the lines with a pen whose ink stays on latex, cut it {x:.0f} × {y:.0f} mm along the
outer line ({grip:g} mm around are for the hands), and punch a hole of {hole:g} mm in every circle."""),
    Text("""Stretch it to {tau:g} times its length in both directions, until each hole is on a tooth of the
ring, {pitch:g} mm from the next. The five squares of {square:g} mm must then read {stretched:g} mm in both
directions. Latex creeps: measure them once more just before gluing."""),
    Text("""The sheet pulls with {load[0]:.0f} N at the left and right sides and {load[1]:.0f} N at the
others. The print comes into the middle of the window; some millimetres beside it do no harm."""))
