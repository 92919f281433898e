# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps from the printed sheet and two sheets of latex to the finished shell."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Iterable, Iterator, Mapping, Sequence

from ..base.errors import tile_name
from ..base.language import ENGLISH, Language, Text
from ..base.native import native
from .shop import latex, reaches_out

GLUE_LAYER = 0.1  # mm of wet glue on what stands out
HOLE = 0.4        # diameter of a hole for a tooth, of the grid's pitch
TRIM = 1.5        # mm from the outer pins to where the surplus is cut

_MARK = Text("""Take {latex}. Wash powder and grease off with lukewarm water and a drop of dish soap, rinse
the sheets and let them dry. Pull each by hand to some {tau:g} times its size and let it go, twice: latex
softens the first time. Then copy the template of each onto it: lay thin latex on the paper and trace what
shows through, or use carbon paper. Draw the grid, the circles, the control squares and the cutting line
with a pen whose ink stays on latex, and write FRONT or BACK on the rim. Cut along the outer line. Punch a
hole of {punch:g} mm in every circle, with a sharp punch: latex tears on from a nick. Wear gloves. Keep the
sheets away from oil, from sun and from whoever is allergic to latex.""")
_STRETCH = Text("""Stretch both membranes to {tau:g} times their length, each over the teeth of its own
ring: every hole comes onto a tooth, {pitch:g} mm from the next. The sheet lies on the face that the teeth
stick out of, with its lines on the ring, since glue does not hold on ink. Begin in the middles of opposite
sides, and end at the corners. The window inside measures {window[0]:.0f} × {window[1]:.0f} mm. The back
ring's teeth, and so its sheet, lie {half:g} mm off its middle along both sides: that is meant, they pass
between those of the front. Measure through the window: each of the five control squares of {square:g} mm
must read {stretched:g} ± {slack:.1f} mm in both directions. Where one does not, a hole hangs on the wrong
tooth or has torn out: hang its rows anew. Stretch both within an hour, and glue both on the same day: latex
that stays stretched loses some quarter of its pull in a day, most of it in the first hours. Measure once
more just before gluing, since latex creeps. The
front sheet pulls with {front[0]:.0f} N at the left and right sides of its ring and {front[1]:.0f} N at the
others, the back sheet with {back[0]:.0f} N and {back[1]:.0f} N: wear goggles, a sheet that slips off snaps
back.""")
_LOOK = Text("""{lies} There are {bodies} bodies: {counts}. The map at the end of this sheet has the
number of each tile. What is missing or broken is printed anew by its number, and laid into its place
before gluing: the program CurveUps writes tile 12 by “curveups export design.json --tiles T00012 -o
spares”. {weak}""")
_LAY = Text("""Lay the {parts} parts, their {first} up, into the frame {name}-frame.dxf, cut of a plate 3
mm thick, by their numbers ({which}), and press them together. A part fits its pocket with its
{first} up alone. Parts that lie askew leave gaps wider than {opening:g} mm: file their edges. The first
membrane is glued over all of them at once.""")
_LAY_BARE = Text("""Print the drawing {name}-frame.pdf at 100 %, and hold the {parts} parts on it by thin
double-sided tape below them, their {first} up, tile on tile, by their numbers ({which}). A part matches
the drawing with its {first} up alone. Gaps between parts are {opening:g} mm wider than those
inside of them, and no tile may be more than {error:g} mm off its place. The first membrane is glued over all
of them at once.""")
_PEEL = Text("""On the {on_bed} {level}. Bridges alone hold the tiles meanwhile, and break easily.""")
_FIRST = Text("""{down}: pins and anchors alone stand out there ({first_mm2:.0f} mm²). {behind} Roll
{first_cm3:.2f} cm³ of glue onto the tops of these, {layer:g} mm thick, with a roller that touches nothing
below: a glue for rubber on hard plastic that water does not loosen. Walls, gaps and all that holds
the tiles together stay dry. {lay} Press sheet and print together between two boards that fit through the
window, with weights spread evenly, for as long as the glue's maker says. Air the room: the glue's vapour
harms you.""")
_TURN = Text("""Turn the print over and lay it, glue down, onto the stretched {first} sheet, in the middle
of the window.""")
_TURN_PIECES = Text("""Turn each of the {pieces} pieces over by itself and lay it, glue down, onto the
stretched {first} sheet, all of them around the middle of the window and as far apart as they were
printed.""")
_LOWER = Text("""Leave all where it lies, and lower the stretched {first} sheet onto it, with its teeth
down and the print in the middle of the window.""")
_AWAY = Text("""Once the glue holds, {away}. {stays}: it alone keeps the tiles in their places now.""")
_SECOND = Text("""Roll {second_cm3:.2f} cm³ of glue onto the pins and anchors of the {second}
({second_mm2:.0f} mm²), as before. Lay the second membrane on, stretched on its ring, with its teeth down:
the rings close face to face, {height:g} mm apart, and the teeth of one stand in the middle between those of
the other. Rods in the holes at the corners align them: punch the rims of the sheets there, where nothing
pulls. Press through both windows, as long as before.""")
_RELEASE = Text("""When the glue holds, turn all over, so that the front sheet is up. Print {name}-trim.pdf
at 100 %, cut the paper to the size of the window, lay it on the front sheet with its triangles on the outer
pins, which you feel through it, and copy its lines onto the sheet. {each} Then cut both sheets at once with
strong scissors along the inside of the window, outside of the anchors, a few centimetres at each side in
turn: so they let go together. The shell pulls itself into shape. Help with your hands where it stays flat,
from the middle outwards. Lay it with its back onto the kit's former: where it does not touch, it is not in
shape yet. {own}""")
_TRIM = Text("""Cut the front membrane along its lines, which were {trim:g} mm outside of the outer pins while
it was stretched, and the back one as far outside of its own pins. {stop} Anchors go with the surplus.
{apart}""")
_EACH = Text("""Where the pieces did not come to lie as far apart as they were printed, cut the paper between
them, and lay each part of it on its own piece.""")
_OWN = Text("""Each piece has its own former, from the left to the right.""")
_STOP = Text("""Follow rims, holes and cuts. Where the drawing has small circles, punch these first: they keep
a cut from tearing on.""")
_APART = Text("So the {pieces} pieces come apart: each holds its shape by itself.")
_FACING = Text("""These tiles lie side by side then, each in a piece of its own: {pairs}.""")
_TAPE = Text("{facing} Nothing joins them: tape or glue them along their borders.")
_SEW = Text("""{facing} Sew with a strong thread through the membrane into a stitching hole ({hole:g} mm), out
at its other side, and back through the hole that faces it in the other piece; {holes} holes in all. A drop of
glue around a hole keeps the membrane from tearing on. Pull the thread tight when all stitches are in.""")


@dataclass(frozen=True)
class Step:
    """picture: what the assembly sheet shows beside it, by its name there."""

    title: str
    text: str
    picture: str = ""

    def __str__(self) -> str:
        return f"{self.title}. {self.text}"


def glue_volumes(block: Mapping[str, Any]) -> dict[str, float]:
    """cm3 of glue on pins and anchors of each side. block: "glue" of report.json's print."""
    return {side: GLUE_LAYER * _area(block, side) / 1000 for side in ("front", "back")}


def glue_asked(report: Mapping[str, Any]) -> float:
    """Shear in MPa that the glue of the most loaded pin or anchor has to hold, rounded up to a hundredth; 0
    where neither is known."""
    shears = [report["glue"]["shear_max_mpa"]] if "glue" in report else []
    shears += report.get("anchors", {}).get("glue_shear_mpa", ())
    return math.ceil(100 * max(shears, default=0.0)) / 100


def steps(report: Mapping[str, Any], parameters: Any, say: Language = ENGLISH) -> list[Step]:
    """Steps of the assembly in their order."""
    values = _values(report, parameters, say)
    return [Step(say(title, **values), say(text, **values), picture)
            for title, text, picture in _steps(report, parameters, values)]


def _values(report: Mapping[str, Any], parameters: Any, say: Language) -> dict[str, Any]:
    """Values that the texts of the steps name. sides: in the order in which they are glued."""
    get, block, sheets = parameters.get, report["print"], report["sheets"]
    beds, support = report.get("beds", {}), native.support_kind(parameters)
    anchors = sheets["anchors"] - beds.get("anchors_left_out", 0)
    others = block["bodies"] - report["tiles"] - anchors
    glue, first = block["glue"], block["glue"]["first"]
    second = "back" if first == "front" else "front"
    on_bed = "back" if get("orientation") == "front-up" else "front"
    words = {"front": say("front"), "back": say("back")}
    slab = glue[f"{second}_support_mm2"]
    reach_out = reaches_out(report, parameters)  # the shop takes supports of a tilted print off
    level = say("the slicer's supports lie level with the pins") if reach_out else \
        say("the slab lies level with the pins ({area:.0f} mm²)", area=slab)
    taped = bool(beds.get("position_error_mm"))
    lay = _LOWER if taped or not others else _TURN_PIECES if block["pieces"] > 1 else _TURN
    down = Text("The parts lie with their {first} up") if taped else \
        Text("Lay the print down with its {first} up")
    removals = [say(text, second=words[second], on_bed=words[on_bed]) for text in (
        *([Text("turn the ring over, so that you can reach the {second}")] if lay == _LOWER else []),
        *([Text("take the drawing and its tape off")] if taped and not support.soluble else []),
        *([Text("peel the slicer's supports off the {on_bed}")] if reach_out and on_bed == second else []),
        *([support.removal] if support.removal else []))]
    away = say("{some} and {last}", some=", ".join(removals[:-1]), last=removals[-1]) if removals[1:] else \
        "".join(removals)
    along = slab or (reach_out and on_bed == second)
    lies = say("As it was printed, the {side} is up.", side=words["front" if on_bed == "back" else "back"])
    stretched, joints = sheets["control_square_stretched_mm"], report.get("joints", {})
    worst = _pairs(row["tiles"] for row in report.get("worst_contacts", ()))
    facing = _pairs(report.get("borders", {}).get("named", ()))
    weak = say("Take care with the tiles of the weakest contacts: {worst}.", worst=worst) if worst else ""
    behind = say("On the {second} {level} and would be glued along.", second=words[second],
                 level=level) if along else ""
    held = say("slabs: {count}", count=others) if support.soluble else say("bridges: {count}", count=others)
    counts = [say("{count} tiles", count=report["tiles"]), say("{count} anchors", count=anchors),
              *([held] if others else [])]
    stays = say("Take the bath that the shop names for its support, if scraps of the latex and the glue have "
                "stood it, and a tub that holds the ring. The membrane stays on its ring while it is washed "
                "and dries") if support.soluble else say("The membrane stays on its ring")
    which = "; ".join(say("from bed {bed}: {parts}", bed=number, parts=", ".join(map(str, row["parts"])))
                      for number, row in enumerate(beds.get("beds", ()), 1))
    return {"name": report["name"], "which": which, "slab": support.soluble, "parts": beds.get("parts", 1),
            "opening": beds.get("opening_mm", 0.0), "error": beds.get("position_error_mm", 0.0),
            "half": sheets["tooth_pitch_mm"] / 2, "stop": say(_STOP) if report["cuts"] else "",
            "latex": latex(report, parameters, say),
            "tau": get("tau"), "window": sheets["window_mm"],
            "pitch": sheets["tooth_pitch_mm"], "square": sheets["control_square_mm"], "stretched": stretched,
            "slack": 0.02 * stretched, "front": sheets["load_n"]["front"], "back": sheets["load_n"]["back"],
            "lies": lies, "bodies": block["bodies"], "counts": ", ".join(counts),
            "punch": HOLE * sheets["grid_mm"], "stays": stays, "level": level, "layer": GLUE_LAYER,
            "away": away, "trim": TRIM, "weak": weak,
            "lay": say(lay, first=words[first], pieces=block["pieces"]),
            "down": say(down, first=words[first]),
            "first": words[first], "first_mm2": _area(glue, first), "first_cm3": glue_volumes(glue)[first],
            "second": words[second], "second_mm2": _area(glue, second),
            "second_cm3": glue_volumes(glue)[second], "behind": behind, "on_bed": words[on_bed],
            "sides": (first, second), "peel_first": reach_out and on_bed == first,
            "each": say(_EACH) if block["pieces"] > 1 else "",
            "own": say(_OWN) if block["pieces"] > 1 else "",
            "facing": say(_FACING, pairs=facing) if facing else "",
            "apart": say(_APART, pieces=block["pieces"]) if block["pieces"] > 1 else "",
            "height": block["bbox_mm"][2],
            "pieces": block["pieces"], "hole": joints.get("hole_mm", 0), "holes": joints.get("holes", 0)}


def _steps(report: Mapping[str, Any], parameters: Any, values: Mapping[str, Any]
           ) -> Iterator[tuple[str, str, str]]:
    """Titles, texts and pictures."""
    first, second = values["sides"]
    yield Text("Wash and mark the latex"), _MARK, "template"
    yield Text("Stretch both sheets"), _STRETCH, "stretched"
    yield Text("Look at the print"), _LOOK, "print"
    if report.get("beds", {}).get("position_error_mm"):
        yield Text("Lay the parts side by side"), _LAY if values["slab"] else _LAY_BARE, "frame"
    if values["peel_first"]:
        yield Text("Peel the slicer's supports off the {on_bed}, tile by tile"), _PEEL, first
    yield Text("Glue the {first} first"), _FIRST, first
    yield Text("Uncover the {second}"), _AWAY, second
    yield Text("Glue the {second} pins and the other end of the anchors"), _SECOND, "section"
    yield Text("Cut both sheets out of their rings together"), _RELEASE, "actuated"
    yield Text("Cut the surplus off"), _TRIM, "trim"
    if values["pieces"] > 1:
        if values["holes"]:
            yield Text("Bring pieces together in shape and sew them along their borders"), _SEW, "actuated"
        else:
            yield Text("Join the pieces"), _TAPE, "actuated"


def _pairs(pairs: Iterable[Sequence[int]]) -> str:
    """Names of pairs of tiles."""
    return ", ".join("–".join(map(tile_name, pair)) for pair in pairs)


def _area(block: Mapping[str, Any], side: str) -> float:
    return float(block[f"{side}_pins_mm2"] + block[f"{side}_anchors_mm2"])
