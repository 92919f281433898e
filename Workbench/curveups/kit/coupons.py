# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coupons: small prints and strips of latex by which walls, glue, gaps, bridges, growth and the membrane are
measured, and MEASURED.json, which `curveups calibrate` reads, with what is known beforehand.

Coupons that depend on how tiles are printed are tiny flat designs, with the bumps and the support of the
design itself; the others are plates.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable, Mapping, Sequence

import numpy as np

from ..base.language import Text
from ..base.native import native
from ..report.shop import has_bridges
from .ring import DOWEL

EDGE, INSET = 15.0, 2.0               # mm, of the tiles of a strip and their pins
PIN = round(math.sqrt(3) / 4 * (EDGE - 2 * math.sqrt(3) * INSET) ** 2, 3)  # mm2
SIDE = round(EDGE - 2 * math.sqrt(3) * INSET, 3)  # mm, of such a pin
GAPS = (0.2, 0.3, 0.4, 0.5, 0.6)      # mm, of the comb
TOOTH, DEEP, BAR = 8.0, 15.0, 6.0     # mm: width of its teeth, their length, and what joins them
WALL, WALL_HEIGHT = 30.0, 8.0         # mm, of tiles that slide on one another
SLED = 7.0                            # mm, height of the one that slides
FOOT_ANGLE = 20.0                     # degrees, between the foot of one and the wall on which it is slid
BLOCKS = ((10.0, 15.0), (20.0, 25.0), (30.0, 35.0))  # mm, whose widths grow
NARROW = (15.0, 75.0)                 # mm, width and length of a strip of latex between its clamps
WIDE = (75.0, 15.0)
GRIP = 20.0                           # mm of the strip at each end
STEPS = 4                             # stretches that are measured, the last is tau
MINUTES = (1, 10, 60, 600, 1440)
TIMES = 5                             # that friction is measured
APART = 4.0                           # mm between plates


Rows = Mapping[str, Any]  # of MEASURED.json; None where something is measured


@dataclass(frozen=True)
class Coupon:
    """rows, model: made from the parameters, the latter a native PrintModel. wanted: whether the design has
    what it measures. own: whether its rows are of the design, or tell what others would be. tiny: a
    design, with its support, and no plate."""

    name: str
    title: str
    text: str
    rows: Callable[[Any], Rows]
    model: Callable[[Any], Any]
    wanted: Callable[[Any], bool] = lambda parameters: True
    own: Callable[[Any], bool] = lambda parameters: True
    tiny: bool = True


def stretches(parameters: Any) -> list[float]:
    return [float(x) for x in 1 + (parameters.get("tau") - 1) * np.arange(1, STEPS + 1) / STEPS]


def pull(parameters: Any) -> dict[str, float]:
    """N at the largest stretch, by the front's modulus (calibration.py has the formulas)."""
    tau = parameters.get("tau")
    stress = parameters.get("shear_modulus_front") * parameters.get("thickness_front")
    return {"narrow": stress * NARROW[0] * (tau - tau**-2), "wide": stress * WIDE[0] * (tau - tau**-3)}


def _changed(parameters: Any, **values: Any) -> Any:
    own = native.Parameters(parameters)
    for name, value in {"anchors": False, **values}.items():
        own.set(name, value)
    return own


def strip(name: str, parameters: Any) -> Any:
    """Tiles in a row, d_gap_min apart, as a native PrintModel."""
    count, height, gap = len(GAPS) + 1, EDGE * math.sqrt(3) / 2, parameters.get("d_gap_min")
    V = np.array([(k * EDGE / 2, (k % 2) * height, 0.0) for k in range(count + 2)])
    F = np.array([(k, k + 2, k + 1) if k % 2 == 0 else (k, k + 1, k + 2) for k in range(count)], np.int32)
    normals = [(math.sqrt(0.75), (-1) ** k * 0.5) for k in range(count - 1)]
    moves = np.vstack([[0, 0], np.cumsum([gap * np.array(n) for n in normals], axis=0)])
    return _model(name, _changed(parameters), V, F, V[F][:, :, :2] + moves[:, None], INSET)


def sliding() -> tuple[np.ndarray, np.ndarray]:
    """Vertices and faces of the tile that is taped to a board, with its foot from the first corner to the
    third, and of the one that slides on it."""
    cosine, sine = math.cos(math.radians(FOOT_ANGLE)), math.sin(math.radians(FOOT_ANGLE))
    V = np.array([(0, 0, 0), (WALL, 0, 0), (WALL * cosine**2, WALL * cosine * sine, 0), (WALL / 2, -SLED, 0)])
    return V, np.array([(0, 1, 2), (1, 0, 3)], np.int32)


def friction(bumps: str, parameters: Any) -> Any:
    """Both of them, as a native PrintModel."""
    V, F = sliding()
    T = V[F][:, :, :2] - np.array([(0, 0), (0, parameters.get("d_gap_min"))])[:, None]
    return _model(f"friction {bumps}", _changed(parameters, bumps=bumps, H_body=WALL_HEIGHT), V, F, T,
                  parameters.get("p_min"))


def _model(name: str, parameters: Any, V: np.ndarray, F: np.ndarray, T: np.ndarray, inset: float) -> Any:
    q = np.full((len(F), 2, 3), inset)
    return native.make_print_model(native.Design(name, parameters, V, F, T, q, np.zeros((0, 2), np.int32)))


def plates(name: str, sizes: Sequence[tuple[float, float]], thickness: float, holes: float = 0.0) -> Any:
    """Plates one above the other, around the origin, as a native PrintModel. holes: mm of their middles from
    both ends."""
    parts: list[Any] = []
    y = -(sum(height for _, height in sizes) + APART * (len(sizes) - 1)) / 2
    for width, height in sizes:
        x = width / 2
        outline = np.array([(-x, y), (x, y), (x, y + height), (-x, y + height)])
        places = [(place, y + height / 2) for place in (holes - x, x - holes)] if holes else []
        parts.append((outline, np.zeros((0, 2)), np.zeros((0, 2)), np.array(places).reshape(-1, 2)))
        y += height + APART
    return native.make_ring(name, parts, thickness, DOWEL / 2, DOWEL)


def comb(name: str, thickness: float) -> Any:
    """Teeth with GAPS between them, in one with what joins them, as a native PrintModel: tiles would come
    apart with their support, and nobody could measure between them."""
    x = -(len(GAPS) * TOOTH + TOOTH + sum(GAPS)) / 2
    top, bottom = (BAR + DEEP) / 2, -(BAR + DEEP) / 2
    outline = [(x, bottom)]
    for gap in (*GAPS, 0.0):
        outline += [(x + TOOTH, bottom), (x + TOOTH, top - BAR), (x + TOOTH + gap, top - BAR),
                    (x + TOOTH + gap, bottom)]
        x += TOOTH + gap
    outline = [*outline[:-3], (x, top), (outline[0][0], top)]  # the last tooth ends at the bar's end
    nothing = np.zeros((0, 2))
    parts: list[Any] = [(np.array(outline), nothing, nothing, nothing)]
    return native.make_ring(name, parts, thickness, DOWEL / 2, DOWEL)


def _bars(parameters: Any) -> Any:
    bars = tuple((width + 4 * DOWEL, 3 * DOWEL) for width, _ in (NARROW, WIDE) for _ in range(4))
    return plates("clamp bars", bars, 2 * DOWEL, 1.5 * DOWEL)


def _height(parameters: Any) -> float:
    return float(2 * parameters.get("H_pin") + parameters.get("H_body"))


def _has_walls(bumps: str, parameters: Any) -> bool:
    return bool(parameters.get("bumps") == bumps)


COUPONS = (
    *(Coupon(f"friction-{name}", title, Text("""Take the support away as from the design. Tape the larger
tile to a board, on its wall that is {angle:g}° off the wall between the tiles. Lay the smaller tile on
that wall as both were printed. Raise the board slowly until the tile slides, and enter the slope of the
wall: that of the board and {angle:g}°. Lay it on again each time. {own}"""),
             lambda parameters: {"friction": [{"angle_deg": None}] * TIMES},
             partial(friction, bumps), own=partial(_has_walls, bumps))
      for name, bumps, title in (("bumps", "bumps", Text("Friction of walls with bumps")),
                                 ("dimples", "dimples", Text("Friction of walls with dimples")),
                                 ("bare", "none", Text("Friction of bare walls")))),
    Coupon("glue", Text("Glue on pins, after the support went"),
           Text("""Glue a strip of the latex, 80 × 25 mm and not stretched, onto the front pins as the
assembly sheet says. Take the support away and let all dry as there. Hold the latex flat on a table and
pull one tile after the other along it, by a thread around its walls, until its pin comes off. Enter the
largest force of each; each pin has {pin:.1f} mm². {asked} Then glue another strip onto the back pins, wash
and dry them as before, and hold the tiles down. Pull the strip straight up, so that it peels off each pin
from a corner towards the side that faces it. Enter the largest force of each (peel): there the glue gives way
along that side, {side:.1f} mm. {peel}"""),
           lambda parameters: {"glue": [{"force_n": None, "area_mm2": PIN}] * (len(GAPS) + 1),
                               "peel": [{"force_n": None, "width_mm": SIDE}] * (len(GAPS) + 1)},
           partial(strip, "glue")),
    Coupon("gaps", Text("Gaps of 0.2 to 0.6 mm"),
           Text("""Push feeler gauges through each gap of the comb, on the side that lay on the bed, where the
first layers swell. Enter the thickest that passes all along, and 0 where none does. The gaps get wider from
the left to the right. Do not order a design whose least clearance (its shop sheet has
it) is below the first gap that is open: its d_gap_min has to be larger."""),
           lambda parameters: {"gaps": [{"nominal_mm": gap, "measured_mm": None} for gap in GAPS]},
           lambda parameters: comb("gaps", _height(parameters)), tiny=False),
    Coupon("bridges", Text("Bridges that break"),
           Text("""Hold one tile of the row after the other in the fingers or a vice, and pull its
neighbour up with a thread around it, at right angles to the row, until the bridges between them break.
Enter the largest force of each. It compares shops and printers: no design computes with it."""),
           lambda parameters: {"bridges": [{"force_n": None}] * len(GAPS)},
           partial(strip, "bridges"), has_bridges),
    Coupon("growth", Text("Growth of the printer"),
           Text("""Measure both widths of each of the three blocks by calliper, in their middles and away
from the side that lay on the bed. Half of what they are wider is what each wall grows: the parameter
xy_compensation."""),
           lambda parameters: {"growth": [{"nominal_mm": width, "measured_mm": None}
                                          for block in BLOCKS for width in block]},
           lambda parameters: plates("growth", BLOCKS, _height(parameters)),
           tiny=False),
    Coupon("clamps", Text("Strips of latex"),
           Text("""Cut both strips along the template, of the sheets for the membranes. Measure the
thickness over ten layers. Stretch each twice to {tau:g} times its length beforehand. Clamp its ends
between two bars with two bolts of M4 in their holes, from line to line of the template. Pull the narrow
strip to each stretch: {lengths} mm from bar to bar, and enter the force after a minute; some {narrow:.0f}
N at the last. So with the wide one: {wide_lengths} mm, some {wide:.0f} N; its width can't shrink, so latex
is stretched in both directions there. Then leave the narrow strip at {tau:g} times its length and read the
force at the minutes that are listed: latex creeps. What a day leaves goes into no design by itself: both
sheets lose alike, so stretch both at the same time. Wear goggles: a strip that tears snaps back."""),
           lambda parameters: {
               "width_mm": NARROW[0], "wide_width_mm": WIDE[0], "thickness_mm": None,
               **{rows: [{"stretch": stretch, "force_n": None} for stretch in stretches(parameters)]
                  for rows in ("strip", "wide")},
               "held": [{"minutes": minutes, "force_n": None} for minutes in MINUTES]}, _bars, tiny=False))


def wanted(parameters: Any) -> list[Coupon]:
    """Those of what a design has."""
    return [one for one in COUPONS if one.wanted(parameters)]


def measured(parameters: Any) -> dict[str, Any]:
    """MEASURED.json before anything is measured."""
    found: dict[str, Any] = {}
    for coupon in wanted(parameters):
        found.update(coupon.rows(parameters) if coupon.own(parameters) else {})
    return found
