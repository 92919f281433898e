# SPDX-License-Identifier: LGPL-2.1-or-later
"""Order for a print shop: its rules, and the figures of a quote."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

from ..base.language import ENGLISH, Language, Text
from ..base.native import native
from ..project.project import Results
from ..stages.solids import fits_bed, fits_turned, overhangs, read_printer
from ..stages.stage import Picture
from .data import has_solids, show

_FLAT = Text("{side}, as the files stand; support is printed with the parts")
_TILTED = Text("{side}, tilted as a whole; the bridges are printed with the parts")
MOST_SIZES = 8  # of beds
_SIDES = {"front-up": Text("front side up"), "front-down": Text("front side down")}


def rules(report: Mapping[str, Any], parameters: Any, say: Language = ENGLISH) -> list[str]:
    """Rules of the order, a sentence each."""
    support, pieces = native.support_kind(parameters), report["print"]["pieces"]
    tilted, beds = is_tilted(parameters), len(report.get("beds", {}).get("beds", ()))
    if support.soluble:
        kept = say("Leave the support in: do not wash it off. It alone keeps the tiles in place. Name the "
                   "bath that dissolves it.")
    elif support.bodies:
        kept = say("Leave the bridges between the tiles in: do not break them. They alone keep the tiles in "
                   "place.")
    else:
        kept = say("Nothing joins the tiles: keep each in its place, on the bed's plate or on adhesive film.")
    build = say("One build: all bodies belong together, {pieces} pieces of them.", pieces=pieces) \
        if pieces > 1 else say("One build: all bodies belong together.")
    if beds > 1:
        build = say("{beds} builds, one a bed: the bodies of a bed belong together.", beds=beds)
    printer = read_printer(parameters.get("printer"))
    fixed = say("Do not scale or arrange: bodies stand in their places, and {tiles} of them are meant to be "
                "apart.", tiles=report["tiles"]) if tilted else \
        say("Do not scale, turn or arrange: bodies stand in their places, and {tiles} of them are meant to "
            "be apart.", tiles=report["tiles"])
    if not beds and not tilted and fits_turned(report["print"]["bbox_mm"], printer):
        fixed = say("Turn all bodies together by a right angle: so they fit the bed. Do not scale or arrange "
                    "them, and do not turn single ones: they stand in their places, and {tiles} of them are "
                    "meant to be apart.", tiles=report["tiles"])
    texts = [kept, say("Ship flat, between two stiff boards."), build, fixed]
    if reaches_out(report, parameters):
        texts.insert(1, say("Let the slicer put supports below tiles that reach out, on the bed alone, and "
                            "leave these in, too: whoever puts the print together takes them off."))
    if tilted:
        texts.append(say("Tilt the whole of it by 30° to 45°, so that no layer is peeled off the vat by its "
                         "whole area, on supports of the slicer's, which touch the side on the bed alone. "
                         "Wash, take these supports off, and cure with the bridges on."))
    return texts


def has_bridges(parameters: Any) -> bool:
    """True if breakaway bridges join the tiles of the print."""
    support = native.support_kind(parameters)
    return bool(support.bodies) and not support.soluble


def is_tilted(parameters: Any) -> bool:
    """True if a layer of the print lying flat would hold to the vat by its whole area."""
    return "resin" in read_printer(parameters.get("printer"))["name"] \
        and not native.support_kind(parameters).soluble


def reaches_out(report: Mapping[str, Any], parameters: Any) -> bool:
    """True if tiles of a print lying flat need the slicer's supports."""
    printer = read_printer(parameters.get("printer"))
    return not is_tilted(parameters) and overhangs(report["print"]["overhang_mm"], parameters, printer)


def quote(report: Mapping[str, Any], parameters: Any, quantity: int = 1, say: Language = ENGLISH,
          whole: Sequence[str] = ()) -> list[tuple[str, str]]:
    """Figures by which a shop quotes, with their labels. whole: as of Kit; the usual names where none are
    given."""
    block, get, name = report["print"], parameters.get, report["name"]
    support = native.support_kind(parameters)
    own = 0.0 if support.soluble else block["support_volume_cm3"]  # of the tiles' own material
    rigid = block["tile_volume_cm3"] + block["anchor_volume_cm3"] + own
    printer = read_printer(get("printer"))
    soft = block["support_volume_cm3"] - own
    bath = support.soluble and soft > 0
    division = report.get("beds", {})
    beds, left_out = division.get("beds", ()), division.get("anchors_left_out", 0)
    pieces = say("in {pieces} separate pieces", pieces=block["pieces"]) if block["pieces"] > 1 else ""
    first, last = whole or ((f"{name}-bed-01.3mf", f"{name}-bed-{len(beds):02}.3mf") if beds else
                            (f"{name}-print.3mf", f"{name}-print.step"))
    files = say("{first} to {last}, or .step: a job a bed, every body with its name, in place. The print as "
                "a whole does not fit the bed", first=first, last=last) if len(beds) > 1 else \
        say("{first} or .step: every body with its name, in place. The print as it is does not fit the bed",
            first=first) if beds else \
        say("{threemf} or {step}: every body with its name, in place; or the files of tiles, anchors and "
            "support, with one origin", threemf=first, step=last)
    boxes = [bed_figures["bbox_mm"] for bed_figures in beds] or [block["bbox_mm"]]
    each = "; ".join(f"{x:.1f} × {y:.1f} × {z:.1f} mm" for x, y, z in boxes[:MOST_SIZES])
    sizes = each if len(boxes) <= MOST_SIZES else say("{each}; the picture has the others", each=each)
    material = say("two materials: {material}, and support that a bath dissolves",
                   material=say(printer["material_class"])) if bath else \
        say("one material: {material}", material=say(printer["material_class"]))
    volumes = {say("tiles"): block["tile_volume_cm3"], say("anchors"): block["anchor_volume_cm3"]}
    if has_bridges(parameters):
        volumes[say(support.bodies)] = own
    parts = ", ".join(f"{kind} {volume:.1f} cm³" for kind, volume in volumes.items())
    soluble = say("{volume:.1f} cm³ (soluble)", volume=soft) if support.soluble else f"{soft:.1f} cm³"
    reach_out = is_tilted(parameters) or reaches_out(report, parameters)
    side = say(_SIDES[get("orientation")])
    fits = say("the print is divided among {beds} beds", beds=len(beds)) if len(beds) > 1 else \
        say("the print fits without {anchors} of its anchors", anchors=left_out) if left_out else \
        say("the print fits as {name} turns and moves it", name=first.rpartition(".")[0]) if beds else \
        say("the print fits, turned by a right angle") if fits_turned(block["bbox_mm"], printer) else \
        say("the print fits") if fits_bed(block["bbox_mm"], printer) else say("the print does not fit")
    bed = " × ".join(f"{side:g}" for side in printer["bed_mm"])
    return [
        (say("Quantity"), say("{quantity}, of {bodies} bodies each ({tiles} tiles) {pieces}",
                              quantity=quantity, bodies=block["bodies"], tiles=report["tiles"],
                              pieces=pieces)),
        (say("To be printed"), files),
        (say("Size"), sizes),
        (say("Material"), material),
        (say("Rigid material"), say("{volume:.1f} cm³, {mass:.0f} g at {density:g} g/cm³ ({parts})",
                                    volume=rigid, mass=rigid * get("density"), density=get("density"),
                                    parts=parts)),
        (say("Support material"), say("{volume}; the slicer's supports under tiles that reach out come on "
                                      "top",
                                      volume=soluble) if reach_out else soluble),
        (say("Layer, tolerance"), say("{layer:g} mm or less, ± {tolerance:g} mm", layer=printer["layer_mm"],
                                      tolerance=printer["tolerance_mm"])),
        (say("Finish"), say(printer["finish"])),
        (say("Orientation"), say(_TILTED if is_tilted(parameters) else _FLAT, side=side)),
        (say("Printer compared with"), say("{printer}: bed {bed} mm, {fits}", printer=say(printer["name"]),
                                           bed=bed, fits=fits)),
        (say("Smallest feature"), say("{feature:.3g} mm; the printer makes {least:g} mm",
                                      feature=block["smallest_feature_mm"],
                                      least=printer["smallest_feature_mm"])),
        (say("Least clearance between tiles"),
         say("{gap} mm; the printer needs {least:g} mm", gap=show(report["solids"]["min_clearance_flat_mm"]),
             least=printer["smallest_gap_mm"])),
    ]


def latex(report: Mapping[str, Any], parameters: Any, say: Language = ENGLISH) -> str:
    """Description of the latex to buy for both membranes."""
    get, sheets = parameters.get, report["sheets"]
    x, y = sheets["cut_mm"]
    thickness, modulus = (_either(say, *(get(f"{name}_{side}") for side in ("front", "back")))
                          for name in ("thickness", "shear_modulus"))
    return say("two sheets of latex, {thickness} mm thick, shear modulus {modulus} MPa, each at least "
               "{x:.0f} × {y:.0f} mm before it is stretched, of which {grip:g} mm around are for the grip",
               thickness=thickness,
               modulus=modulus, x=x, y=y, grip=sheets["grip_mm"])


def print_picture(results: Results) -> Optional[Picture]:
    """Picture of all that is printed, where there are solids."""
    if not has_solids(results):
        return None
    model, printer = results["bodies"].model, read_printer(results.parameters.get("printer"))
    return Picture("", "All that is printed, seen from above: tiles, anchors, and what holds "
                       "them together.", "print_pictures.print_view",
                   {"models": [model], "bed": printer["bed_mm"]})


def _either(say: Language, front: float, back: float) -> str:
    """Text of a number, or of the front's and the back's."""
    if front == back:
        return f"{front:g}"
    return say("{front:g} (front) and {back:g} (back)", front=front, back=back)
