# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a stretching ring: solids for a printer, and plywood for a laser or a saw and a drill, at full
size."""

from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np
from matplotlib.path import Path as Outline

from ..base.language import ENGLISH, Language
from ..base.native import native
from .drawing import Drawing, dxf
from .kit import Kit
from .ring import DOWEL, FLARE, RIM, TONGUE, Cut, cuts, frame_width, outer_size, teeth, tongues


Part = tuple[Any, Any, Any, Any]  # outline, window, teeth, holes: n x 2


def make(kit: Kit, side: str, kind: str) -> bytes:
    """A side's ring as step, stl or dxf (plywood)."""
    block, ring = kit.report["sheets"], kit.rings
    title = kit.say("{title}, {side} ring", title=kit.title, side=kit.say(side))
    if kind == "dxf":
        return dxf(frame(title, block, side, ring["thickness_mm"], kit.say))
    return kit.written(solids(title, block, side, ring, kit.printer), kind, "print")


def solids(title: str, block: Mapping[str, Any], side: str, ring: Mapping[str, Any],
           printer: Mapping[str, Any]) -> Any:
    """A native PrintModel of the parts at their places."""
    bodies = parts(block, side, printer["bed_mm"], printer["tolerance_mm"])
    return native.make_ring(title, bodies, ring["thickness_mm"], DOWEL / 2, ring["tooth_height_mm"])


def parts(block: Mapping[str, Any], side: str, bed: Sequence[float], fit: float
          ) -> list[Part]:
    """Outline, window, teeth and holes of each part. fit: mm that stay free between parts."""
    places, holes = teeth(block, side), np.array(_corners(outer_size(block), RIM / 2))
    outer, width = outer_size(block), frame_width(block)
    places_of_cuts = cuts(block, side, bed)
    if not places_of_cuts:
        return [(np.array(_corners(outer)), np.array(_corners(outer, width)), places, holes)]
    whole = []
    for cut, following in zip(places_of_cuts, places_of_cuts[1:] + places_of_cuts[:1]):
        # Corners between the two cuts; the inner ones are passed on the way back.
        between = [k % 4 for k in range(cut[0] + 1, following[0] + 1 + 4 * (following <= cut))]
        inner = [_corners(outer, width)[k] for k in reversed(between)]
        line = np.array([*(_corners(outer)[k] for k in between), *_profile(block, places, following, 0.0),
                         *inner, *_profile(block, places, cut, fit)[::-1]])
        inside = Outline(line).contains_points
        whole.append((line, np.zeros((0, 2)), places[inside(places)], holes[inside(holes)]))
    return whole


def _corners(size: Sequence[float], inset: float = 0.0) -> list[tuple[float, float]]:
    """Corners of a rectangle, counter-clockwise from the lower left."""
    x, y = size[0] - inset, size[1] - inset
    return [(inset, inset), (x, inset), (x, y), (inset, y)]


def _profile(block: Mapping[str, Any], places: np.ndarray, cut: Cut, fit: float) -> list[np.ndarray]:
    """A cut's line from the outer edge to the window, with dovetails in the direction of going around."""
    corners = np.array(_corners(outer_size(block)))
    start, along = corners[cut[0]], np.roll(corners, -1, axis=0)[cut[0]] - corners[cut[0]]
    along = along / np.linalg.norm(along)
    inwards, width = np.array([-along[1], along[0]]), frame_width(block)
    s, t = (places - start) @ along - cut[1], (places - start) @ inwards
    rows = sorted(set(np.round(t[(abs(s) < block["tooth_pitch_mm"]) & (t < width)], 6)))
    line = [(fit, 0.0)]
    for middle, wide in tongues(rows, width):
        neck, tip = wide / 2 - FLARE + fit, wide / 2 + fit
        line += [(fit, middle - neck), (TONGUE + fit, middle - tip), (TONGUE + fit, middle + tip),
                 (fit, middle + neck)]
    return [start + (cut[1] + s) * along + t * inwards for s, t in [*line, (fit, width)]]


def frame(title: str, block: Mapping[str, Any], side: str, thickness: float, say: Language = ENGLISH
          ) -> Drawing:
    """The face with the teeth. Layer cut: outline, window and holes at the corners for dowels that align both
    rings; layer control: holes of teeth."""
    width, outer = frame_width(block), outer_size(block)
    drawing = Drawing(title, (outer[0], outer[1]))
    drawing.box("cut", 0, 0, *outer)
    drawing.box("cut", width, width, *map(float, block["window_mm"]))
    for x, y in _corners(outer, RIM / 2):
        drawing.circle("cut", x, y, DOWEL / 2)
    for tooth in teeth(block, side):
        drawing.circle("control", float(tooth[0]), float(tooth[1]), DOWEL / 2)
    words = say("{title}: {thickness:g} mm plywood, holes {hole:g} mm", title=title, thickness=thickness,
                hole=DOWEL)
    drawing.text(RIM, 2.0, 5.0, words)
    return drawing


def section(kit: Kit) -> Drawing:
    """Rings, sheets and print on one another, from the side; the window is shortened."""
    ring, pitch, say = kit.rings, kit.report["sheets"]["tooth_pitch_mm"], kit.say
    width, thickness, tooth, high = (ring[name] for name in ("width_mm", "thickness_mm", "tooth_height_mm",
                                                             "apart_mm"))
    print_width, words = 6 * pitch, 4.0
    whole = 2 * width + print_width + 2 * pitch
    drawing = Drawing(kit.title, (whole + 1, 2 * thickness + high + 4 * words))  # whole lines at the edge
    first = kit.report["print"]["glue"]["first"]
    sides = (first, "back" if first == "front" else "front")
    low = 2 * words
    for side, face, up in ((sides[0], low + thickness, 1), (sides[1], low + thickness + high, -1)):
        for x in (0.0, whole - width):
            drawing.box("grid", x, face if up < 0 else face - thickness, width, thickness)
        shift = 0.0 if side == "front" else 0.5
        for row in range(1, kit.report["sheets"]["tooth_rows"] + 1):
            for x in (width - (row - shift) * pitch, whole - width + (row - shift) * pitch):
                drawing.box("grid", x - DOWEL / 2, face if up > 0 else face - tooth, DOWEL, tooth)
        drawing.line("cut", (0, face), (whole, face))
        drawing.fitted(2, face - up * (thickness / 2) - words / 2, words,
                       say("{side} ring", side=say(side)), width - 4)
        drawing.fitted(width + pitch, face - up * 1.8 * words - words / 2, words,
                       say("{side} sheet, its lines on this side", side=say(side)), print_width)
    for x in (RIM / 2, whole - RIM / 2):
        drawing.box("grid", x - DOWEL / 2, low, DOWEL, 2 * thickness + high)
    drawing.box("control", width + pitch, low + thickness, print_width, high)
    drawing.centred(whole / 2, low + thickness + high / 2, min(words, 0.6 * high), say("print"))
    return drawing
