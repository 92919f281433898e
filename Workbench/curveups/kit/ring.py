# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rings on which sheets of latex stay stretched: frames around an open window, with rounded teeth. They
are printed, in parts with dovetails where the bed is small, or made of plywood with dowels as teeth. The
window is for washing and for pressing from behind. The sheet lies on the face that the teeth stick out of.
The two rings close on the print face to face, so the back's teeth stand half a pitch beside the front's, and
are lower than the print is high.

The sheet pulls at the teeth within the frame's plane and above its middle. So a side bends inwards as a beam
of a closed frame, and turns: that bends its neighbours out of the plane. Beam formulas with shear and torsion
give the deflections of a ring in one part; a dovetail in the middle of a side adds a tenth. The plate is
thick enough to stay below a millimetre.
"""

from __future__ import annotations

import math
from typing import Any, Mapping, Optional, Sequence

import numpy as np

THICKNESSES = (12.0, 15.0, 18.0, 21.0, 24.0, 30.0)  # mm, of which plywood is sold
MODULUS = 2000.0     # MPa, of rigid photopolymers; PLA and plywood have more
POISSON = 0.35
MOST = 0.9           # mm that a side may give way without dovetails
DOWEL = 5.0          # mm, diameter of teeth
TOOTH = 7.0          # mm that a tooth sticks out, at most
CLEAR = 0.5          # mm between a tooth and the other ring's sheet
RIM = 15.0           # mm beyond the outer teeth
EDGE = 5.0           # mm of the bed that stay free around a part
TONGUE = 10.0        # mm, length of a dovetail
WALL = 1.5           # mm between a tooth and a dovetail
FLARE = 1.0          # mm by which a dovetail is wider at its end, on each side

Cut = tuple[int, float]  # the side that is cut (below, right, above, left), and mm from its first corner


def teeth(block: Mapping[str, Any], side: str) -> np.ndarray:
    """Places of teeth from the frame's lower left corner, mm. block: "sheets" of report.json."""
    pitch, rows = block["tooth_pitch_mm"], block["tooth_rows"]
    columns, lines = (round(size / pitch) + 2 * rows for size in block["window_mm"])
    places = [(i, j) for i in range(columns + 1) for j in range(lines + 1)
              if min(i, j, columns - i, lines - j) < rows]
    shift = 0.0 if side == "front" else 0.5
    return (np.array(places, float) - rows + shift) * pitch + frame_width(block)


def frame_width(block: Mapping[str, Any]) -> float:
    """Width of the frame around the window, mm: the teeth of either ring and a rim."""
    return float((block["tooth_rows"] + 0.5) * block["tooth_pitch_mm"] + RIM)


def outer_size(block: Mapping[str, Any]) -> list[float]:
    """Size of a ring, x and y, mm."""
    return [size + 2 * frame_width(block) for size in block["window_mm"]]


def cuts(block: Mapping[str, Any], side: str, bed: Sequence[float]) -> list[Cut]:
    """Cuts of the frame, between columns of teeth, in the order of its sides, so that its parts fit the
    bed; none where it fits whole. A bed that is too small for corners gets the smallest parts that there
    are."""
    outer, counts = outer_size(block), [(x, y) for x in range(1, 30) for y in range(1, 30)]
    ways = [way for x, y in sorted(counts, key=sum) if (way := _cut(block, side, x, y))]
    x, y = next((way for way in ways if _fits(way, outer, bed)), ways[-1])
    return [*((0, place) for place in x), *((1, place) for place in y),
            *((2, outer[0] - place) for place in reversed(x)),
            *((3, outer[1] - place) for place in reversed(y))]


def _cut(block: Mapping[str, Any], side: str, *counts: int) -> Optional[list[list[float]]]:
    """Places of cuts along x and y for so many parts; none where a corner would be cut."""
    pitch, width = block["tooth_pitch_mm"], frame_width(block)
    first = width + (pitch / 2 if side == "front" else pitch)
    cuts_along = []
    for size, count in zip(outer_size(block), counts):
        places = [first + pitch * round((size * k / count - first) / pitch) for k in range(1, count)]
        if any(place < width + WALL or place + TONGUE > size - width for place in places):
            return None
        cuts_along.append(places)
    return cuts_along


def _fits(places: Sequence[Sequence[float]], outer: Sequence[float], bed: Sequence[float]) -> bool:
    longest = [max(np.diff([0.0, *along, size])) + TONGUE * bool(along) for along, size in zip(places, outer)]
    return all(part + 2 * EDGE <= room for part, room in zip(sorted(longest), sorted(bed[:2])))


def tongues(rows: Sequence[float], width: float) -> list[tuple[float, float]]:
    """Middle and width of the dovetails of a cut, mm from the outer edge, between rows of teeth there."""
    ends = [2 * WALL, *(row + sign * (DOWEL / 2 + WALL) for row in sorted(rows) for sign in (-1, 1)),
            width - 2 * WALL]
    return [((low + high) / 2, high - low) for low, high in zip(ends[::2], ends[1::2]) if high - low >= DOWEL]


def rings(block: Mapping[str, Any], height: float, bed: Sequence[float]) -> dict[str, Any]:
    """Sizes of the rings, what they carry and how they give way: N, mm, MPa; x and y. height: of the
    print."""
    window, width = block["window_mm"], frame_width(block)
    tooth = min(TOOTH, height - CLEAR)
    pulls = {side: load[0] / window[1] for side, load in block["load_n"].items()}  # N/mm
    cut = {side: cuts(block, side, bed) for side in pulls}
    for thickness in THICKNESSES:
        bends = {side: _gives_way(block, pull, thickness, tooth) for side, pull in pulls.items()}
        if max(max(both) for of_side in bends.values() for both in of_side) < MOST:
            break
    sides = {side: {"load_n": block["load_n"][side], "parts": max(1, len(cut[side])),
                    "bends_mm": bends[side][0], "rises_mm": bends[side][1],
                    "tooth_n": pull * block["tooth_pitch_mm"],
                    "tooth_mpa": 32 * pull * block["tooth_pitch_mm"] * tooth / (math.pi * DOWEL ** 3)}
             for side, pull in pulls.items()}
    return {"thickness_mm": thickness, "width_mm": width, "outer_mm": outer_size(block), "dowel_mm": DOWEL,
            "dowel_length_mm": thickness + tooth, "teeth": len(teeth(block, "front")),
            "tooth_height_mm": tooth, "apart_mm": height, "modulus_mpa": MODULUS, **sides}


def _gives_way(block: Mapping[str, Any], pull: float, thickness: float, tooth: float
               ) -> tuple[list[float], list[float]]:
    """Deflections in mm of the middles of sides along x and y: inwards, and of their inner edges out of the
    plane. pull: N/mm."""
    width = frame_width(block)
    spans = [size + width for size in block["window_mm"]]  # between the middles of corners
    shear = MODULUS / (2 + 2 * POISSON)
    upright, level = thickness * width ** 3 / 12, width * thickness ** 3 / 12
    torsion = width * thickness ** 3 / 3 * (1 - 0.63 * thickness / width)
    turning = pull * (thickness + tooth) / 2
    corner = pull * sum(span ** 3 for span in spans) / (12 * sum(spans))
    inwards, out = [], []
    for span, other in (spans, spans[::-1]):
        bent = (5 * pull * span ** 4 / 384 - corner * span ** 2 / 8) / (MODULUS * upright)
        bent += pull * span ** 2 / 8 / (5 / 6 * shear * width * thickness)
        end = turning * other / 2  # constant along the side
        risen = end * span ** 2 / (8 * MODULUS * level)
        risen += width / 2 * (turning * span * other / (4 * MODULUS * level)
                              + turning * span ** 2 / (8 * shear * torsion))
        inwards.append(bent)
        out.append(risen)
    return inwards, out
