# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps from the printed sheet and two sheets of latex to the finished shell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Mapping

from ..base.errors import tile_name
from ..base.native import native
from ..stages.solids import overhangs, read_printer
from .shop import latex

GLUE_LAYER = 0.1  # mm of wet glue on what stands out
TRIM = 1.5        # mm from the outer pins to where the surplus is cut

_MARK = """Take {latex}. Wash powder and grease off and let the sheets dry. Stretch each to its full length
and let it go, twice: latex softens the first time. Trace the grid, the control squares and the cutting line
of the templates only then. Wear gloves. Keep the sheets away from oil, from sun and from whoever is
allergic to latex."""
_STRETCH = """Stretch both membranes to {tau:g} times their length, each on its ring around a window of
{window[0]:.0f} × {window[1]:.0f} mm: every crossing of the grid comes to a tooth, {pitch:g} mm from the
next. Begin in the middles of opposite sides, and end at the corners. Each of the five control squares of
{square:g} mm must read {stretched:g} ± {slack:.1f} mm in both directions, once more just before gluing: latex
creeps. The front sheet pulls at the sides of its ring with {front[0]:.0f} N and {front[1]:.0f} N, the back
sheet with {back[0]:.0f} N and {back[1]:.0f} N: a ring that lets go snaps back."""
_LOOK = """{label}There are {bodies} bodies: {tiles} tiles, {anchors} anchors and {others} of what holds
them together. Take a tile that is missing or broken from the spares (curveups export --tiles), by its
number.{weak}"""
_LAY = """lay the {parts} parts into the frame {name}-frame.dxf, cut of a plate 3 mm thick, by their numbers,
and press them together. Parts that lie askew leave gaps wider than {opening:g} mm: file their edges. The
first membrane is glued over all of them at once."""
_LAY_BARE = """tape the {parts} parts onto the drawing {name}-frame.dxf, tile on tile, at full size. The first
membrane is glued over all of them at once."""
_PEEL = """{level} there. Bridges alone hold the tiles meanwhile, and break easily."""
_FIRST = """its pins and anchors alone stand out there ({first_mm2:.0f} mm²){behind}. Roll {first_cm3:.2f}
cm³ of glue, {layer:g} mm, onto their tops, with a roller that touches nothing below: a flexible glue for
rubber on hard plastic that water does not loosen. Walls, gaps and all that holds the tiles together stay
dry. Lay the print on the stretched sheet, glue down, in the middle of the window. Press it down for as long
as the glue's maker says. Air the room: the glue's vapour harms you."""
_AWAY = """once the glue holds, {away}. The membrane stays on its ring{washed}: it alone keeps the tiles in
their places now."""
_NOTHING_AWAY = """once the glue holds. The membrane stays on its ring: it alone keeps the tiles in their
places."""
_SECOND = """{second_mm2:.0f} mm², {second_cm3:.2f} cm³ of glue. Lay the second membrane on, stretched on
its ring: the rings close face to face, {height:g} mm apart, and their teeth stand half a pitch beside one
another. Rods in the holes at the corners align them. Press through the windows, as long as before."""
_RELEASE = """when the glue holds, side by side. It pulls itself into shape. Help with your hands where it
stays flat, from the middle outwards. Lay it over the kit's former, or its ribs: a gap shows where it
is not in shape yet."""
_TRIM = """trim the anchors off with the surplus membrane, {trim:g} mm outside of the outer pins, along
rims, holes and cuts.{apart}"""
_APART = " So the {pieces} pieces come apart: each holds its shape by itself."
_TAPE = """nothing joins them: tape or glue them along their borders."""
_SEW = """through the membrane into a stitching hole ({hole:g} mm), out at its other side, and back through
the hole that faces it in the other piece; {holes} holes in all. A drop of glue around a hole keeps the
membrane from tearing on. Pull the thread tight when all stitches are in."""


@dataclass(frozen=True)
class Step:
    """picture: what the assembly sheet shows beside it, by its name there."""

    title: str
    text: str
    picture: str = ""

    def __str__(self) -> str:
        return f"{self.title}: {self.text}"


def glue_volumes(block: Mapping[str, Any]) -> dict[str, float]:
    """cm3 of glue on pins and anchors of each side. block: "glue" of report.json's print."""
    return {side: GLUE_LAYER * _area(block, side) / 1000 for side in ("front", "back")}


def steps(report: Mapping[str, Any], parameters: Any) -> list[Step]:
    """What is done in which order, for whoever puts it together."""
    values = _values(report, parameters)
    return [Step(title.format(**values), " ".join(text.split()).format(**values), picture)
            for title, text, picture in _steps(report, parameters, values)]


def _values(report: Mapping[str, Any], parameters: Any) -> dict[str, Any]:
    """What the steps' texts name."""
    get, block, sheets = parameters.get, report["print"], report["sheets"]
    glue, first = block["glue"], block["glue"]["first"]
    second = "back" if first == "front" else "front"
    on_bed = "back" if get("orientation") == "front-up" else "front"
    level = f"the slab lies level with the pins ({glue[f'{second}_support_mm2']:.0f} mm²)"
    support = native.support_kind(parameters)
    away = support.removal.format(second=second)
    reach_out = overhangs(block["overhang_mm"], parameters, read_printer(get("printer")))
    if reach_out:
        level = "the slicer's supports lie level with the pins"
        if on_bed == second:
            away = f"peel the slicer's supports off the {on_bed}" + (f", {away}" if away else "")
    along = glue[f"{second}_support_mm2"] or "peel" in away
    label = (f"The label beside an anchor of each piece says {'FRONT' if on_bed == 'back' else 'BACK'} on "
             "that side. " if get("anchors") and get("engrave") else "")
    stretched, joints = sheets["control_square_stretched_mm"], report.get("joints", {})
    worst = ", ".join("–".join(map(tile_name, one["tiles"])) for one in report.get("worst_contacts", ()))
    beds = report.get("beds", {})
    return {"name": report["name"], "slab": support.soluble, "parts": beds.get("parts", 1),
            "opening": beds.get("opening_mm", 0.0), "latex": latex(report, parameters), "tau": get("tau"),
            "window": sheets["window_mm"],
            "pitch": sheets["tooth_pitch_mm"], "square": sheets["control_square_mm"], "stretched": stretched,
            "slack": 0.02 * stretched, **sheets["load_n"], "label": label, "bodies": block["bodies"],
            "anchors": sheets["anchors"], "others": block["bodies"] - report["tiles"] - sheets["anchors"],
            "tiles": report["tiles"], "level": level, "layer": GLUE_LAYER, "away": away, "trim": TRIM,
            "washed": " while it is washed and dries" if support.soluble else "",
            "weak": f" Take care with the tiles of the weakest contacts: {worst}." if worst else "",
            "first": first, "first_mm2": _area(glue, first), "first_cm3": glue_volumes(glue)[first],
            "second": second, "second_mm2": _area(glue, second), "second_cm3": glue_volumes(glue)[second],
            "behind": f"; on the {second} {level} and would be glued along" if along else "",
            "on_bed": on_bed, "peel_first": reach_out and on_bed == first,
            "apart": _APART.format(pieces=block["pieces"]) if block["pieces"] > 1 else "",
            "height": block["bbox_mm"][2],
            "pieces": block["pieces"], "hole": joints.get("hole_mm", 0), "holes": joints.get("holes", 0)}


def _steps(report: Mapping[str, Any], parameters: Any, values: Mapping[str, Any]
           ) -> Iterator[tuple[str, str, str]]:
    """Titles, texts and pictures."""
    yield "Wash and mark the latex", _MARK, "template"
    yield "Stretch both sheets", _STRETCH, "stretched"
    yield "Look at the print", _LOOK, "print"
    if report.get("beds", {}).get("position_error_mm"):
        yield "Lay the parts side by side", _LAY if values["slab"] else _LAY_BARE, "frame"
    if values["peel_first"]:
        yield "Peel the slicer's supports off the {on_bed}, tile by tile", _PEEL, values["first"]
    yield "Glue the {first} first", _FIRST, values["first"]
    yield "Turn the sheet over", _AWAY if values["away"] else _NOTHING_AWAY, values["second"]
    yield "Glue the {second} pins and the other end of the anchors", _SECOND, values["second"]
    yield "Take both sheets off their rings together", _RELEASE, "actuated"
    yield "Cut the surplus off", _TRIM, "trim"
    if values["pieces"] > 1:
        if values["holes"]:
            yield "Bring pieces together in shape and sew them along their borders", _SEW, "actuated"
        else:
            yield "Join the pieces", _TAPE, "actuated"


def _area(block: Mapping[str, Any], side: str) -> float:
    return float(block[f"{side}_pins_mm2"] + block[f"{side}_anchors_mm2"])
