# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps from the printed sheet and two sheets of latex to the finished shell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator, Mapping

from ..base.errors import tile_name
from ..base.language import ENGLISH, Language, Text
from ..base.native import native
from ..stages.solids import overhangs, read_printer
from .shop import latex

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
sides, and end at the corners. The window inside measures {window[0]:.0f} × {window[1]:.0f} mm. Measure
through it: each of the five control squares of {square:g} mm must read {stretched:g} ± {slack:.1f} mm in
both directions. Measure once more just before gluing, since latex creeps, and stretch anew what has become
smaller. The front sheet pulls at the sides of its ring with {front[0]:.0f} N and {front[1]:.0f} N, the
back sheet with {back[0]:.0f} N and {back[1]:.0f} N: wear goggles, a sheet that slips off snaps back.""")
_LOOK = Text("""{label} There are {bodies} bodies: {counts}. The map at the end of this sheet has the
number of each tile. What is missing or broken is printed anew by its number, and laid into its place
before gluing: “curveups export design.json --tiles T00012 -o spares” writes tile 12. {weak}""")
_LAY = Text("""Lay the {parts} parts, their {first} up, into the frame {name}-frame.dxf, cut of a plate 3
mm thick, by their numbers, and press them together. Parts that lie askew leave gaps wider than {opening:g}
mm: file their edges. The first membrane is glued over all of them at once.""")
_LAY_BARE = Text("""Tape the {parts} parts, their {first} up, onto the drawing {name}-frame.dxf, tile on
tile, at full size. The first membrane is glued over all of them at once.""")
_PEEL = Text("""On the {on_bed} {level}. Bridges alone hold the tiles meanwhile, and break easily.""")
_FIRST = Text("""Lay the print down with its {first} up: pins and anchors alone stand out there
({first_mm2:.0f} mm²). {behind} Roll {first_cm3:.2f} cm³ of glue onto their tops, {layer:g} mm thick, with
a roller that touches nothing below: a flexible glue for rubber on hard plastic that water does not loosen.
Walls, gaps and all that holds the tiles together stay dry. {lay} Press sheet and print together between
two boards that fit through the window, with weights spread evenly, for as long as the glue's maker says.
Air the room: the glue's vapour harms you.""")
_TURN = Text("""Turn the print over and lay it, glue down, onto the stretched {first} sheet, in the middle
of the window.""")
_LOWER = Text("""Leave all where it lies, and lower the stretched {first} sheet onto it, with its teeth
down and the print in the middle of the window.""")
_AWAY = Text("""Once the glue holds, turn the ring over, so that you can reach the {second}, and {away}.
{stays}: it alone keeps the tiles in their places now.""")
_NOTHING_AWAY = Text("""Once the glue holds, the {second} is up. The membrane stays on its ring: it alone
keeps the tiles in their places.""")
_SECOND = Text("""Roll {second_cm3:.2f} cm³ of glue onto the pins and anchors of the {second}
({second_mm2:.0f} mm²), as before. Lay the second membrane on, stretched on its ring, with its teeth down:
the rings close face to face, {height:g} mm apart, and their teeth stand half a pitch beside one another.
Rods in the holes at the corners align them. Press through both windows, as long as before.""")
_RELEASE = Text("""When the glue holds, print {name}-trim.pdf at 100 %, lay it on the front sheet with its
triangles on the outer pins, and copy its lines onto the sheet. Then lift both sheets off their teeth
together, one side after the other. The shell pulls itself into shape. Help with your hands where it stays
flat, from the middle outwards. Lay it over the kit's former, or its ribs: where it does not touch, it is
not in shape yet.""")
_TRIM = Text("""Cut both membranes along the lines, {trim:g} mm outside of the outer pins, along rims,
holes and cuts. Where the drawing has small circles, punch these first: they keep a cut from tearing on.
Anchors go with the surplus. {apart}""")
_APART = Text("So the {pieces} pieces come apart: each holds its shape by itself.")
_TAPE = Text("Nothing joins them: tape or glue them along their borders.")
_SEW = Text("""Sew with a strong thread through the membrane into a stitching hole ({hole:g} mm), out at
its other side, and back through the hole that faces it in the other piece; {holes} holes in all. A drop of
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


def steps(report: Mapping[str, Any], parameters: Any, say: Language = ENGLISH) -> list[Step]:
    """What is done in which order, for whoever puts it together."""
    values = _values(report, parameters, say)
    return [Step(say(title, **values), say(text, **values), picture)
            for title, text, picture in _steps(report, parameters, values)]


def _values(report: Mapping[str, Any], parameters: Any, say: Language) -> dict[str, Any]:
    """What the steps' texts name. sides: which is glued first, and which then."""
    get, block, sheets = parameters.get, report["print"], report["sheets"]
    glue, first = block["glue"], block["glue"]["first"]
    second = "back" if first == "front" else "front"
    on_bed = "back" if get("orientation") == "front-up" else "front"
    words = {"front": say("front"), "back": say("back")}
    slab = glue[f"{second}_support_mm2"]
    level = say("the slab lies level with the pins ({area:.0f} mm²)", area=slab)
    support = native.support_kind(parameters)
    away = say(support.removal, second=words[second])
    reach_out = overhangs(block["overhang_mm"], parameters, read_printer(get("printer")))
    if reach_out:
        level = say("the slicer's supports lie level with the pins")
        if on_bed == second:
            peel = say("peel the slicer's supports off the {on_bed}", on_bed=words[on_bed])
            away = ", ".join(filter(None, (peel, away)))
    along = slab or (reach_out and on_bed == second)
    label = say("The label beside an anchor of each piece says {side} on that side.",
                side="FRONT" if on_bed == "back" else "BACK") if get("anchors") and get("engrave") else \
        say("As it was printed, the {side} is up.", side=words["front" if on_bed == "back" else "back"])
    stretched, joints = sheets["control_square_stretched_mm"], report.get("joints", {})
    worst = ", ".join("–".join(map(tile_name, one["tiles"])) for one in report.get("worst_contacts", ()))
    weak = say("Take care with the tiles of the weakest contacts: {worst}.", worst=worst) if worst else ""
    beds = report.get("beds", {})
    behind = say("On the {second} {level} and would be glued along.", second=words[second],
                 level=level) if along else ""
    others = block["bodies"] - report["tiles"] - sheets["anchors"]
    held = say("slabs: {count}", count=others) if support.soluble else say("bridges: {count}", count=others)
    counts = [say("{count} tiles", count=report["tiles"]), say("{count} anchors", count=sheets["anchors"]),
              *([held] if others else [])]
    stays = say("Take the bath that the shop names for its support. The membrane stays on its ring while it "
                "is washed and dries") if support.soluble else say("The membrane stays on its ring")
    return {"name": report["name"], "slab": support.soluble, "parts": beds.get("parts", 1),
            "opening": beds.get("opening_mm", 0.0), "latex": latex(report, parameters, say),
            "tau": get("tau"), "window": sheets["window_mm"],
            "pitch": sheets["tooth_pitch_mm"], "square": sheets["control_square_mm"], "stretched": stretched,
            "slack": 0.02 * stretched, "front": sheets["load_n"]["front"], "back": sheets["load_n"]["back"],
            "label": label, "bodies": block["bodies"], "counts": ", ".join(counts),
            "punch": HOLE * sheets["grid_mm"], "stays": stays, "level": level, "layer": GLUE_LAYER,
            "away": away, "trim": TRIM, "weak": weak,
            "lay": say(_TURN if others and not beds.get("position_error_mm") else _LOWER, first=words[first]),
            "first": words[first], "first_mm2": _area(glue, first), "first_cm3": glue_volumes(glue)[first],
            "second": words[second], "second_mm2": _area(glue, second),
            "second_cm3": glue_volumes(glue)[second], "behind": behind, "on_bed": words[on_bed],
            "sides": (first, second), "peel_first": reach_out and on_bed == first,
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
    yield Text("Turn the sheet over"), _AWAY if values["away"] else _NOTHING_AWAY, second
    yield Text("Glue the {second} pins and the other end of the anchors"), _SECOND, "section"
    yield Text("Take both sheets off their rings together"), _RELEASE, "actuated"
    yield Text("Cut the surplus off"), _TRIM, "trim"
    if values["pieces"] > 1:
        if values["holes"]:
            yield Text("Bring pieces together in shape and sew them along their borders"), _SEW, "actuated"
        else:
            yield Text("Join the pieces"), _TAPE, "actuated"


def _area(block: Mapping[str, Any], side: str) -> float:
    return float(block[f"{side}_pins_mm2"] + block[f"{side}_anchors_mm2"])
