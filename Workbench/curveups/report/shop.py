# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a print shop has to know: the rules of the order, and what it quotes by."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from ..base.native import native
from ..project.project import Results
from ..stages.solids import fits_bed, overhangs, read_printer
from ..stages.stage import Picture
from .data import has_solids
from .tables import show

_SIDES = {"front-up": "front side up", "front-down": "front side down"}


def rules(report: Mapping[str, Any], parameters: Any) -> list[str]:
    """What the shop must do, and must not."""
    support, pieces = native.support_kind(parameters), report["print"]["pieces"]
    printer = read_printer(parameters.get("printer"))
    tilted = _tilted(support, printer)
    if support.soluble:
        kept = "Leave supports and bridges in: do not wash them off. They alone keep the tiles in place."
    elif support.bodies:
        kept = "Leave supports and bridges in: do not break them. They alone keep the tiles in place."
    else:
        kept = "Nothing joins the tiles: keep each in its place, on the bed's plate or on adhesive film."
    one = "One build: all bodies belong together" + f", {pieces} pieces of them" * (pieces > 1)
    fixed = "Do not scale or arrange" if tilted else "Do not scale, turn or arrange"
    return [kept, "Ship flat, between two stiff boards.", f"{one}.",
            f"{fixed}: bodies stand in their places, and {report['tiles']} of them are meant to be apart.",
            *(["Tilt the whole of it by 30° to 45° on supports of the slicer's, which touch the side on the "
               "bed alone. Wash, and cure with the bridges on."] if tilted else [])]


def _tilted(support: Any, printer: dict[str, Any]) -> bool:
    """Whether a layer of the print lying flat would hold to the vat by its whole area."""
    return "resin" in printer["name"] and not support.soluble


def quote(report: Mapping[str, Any], parameters: Any, quantity: int = 1) -> list[tuple[str, str]]:
    """What a shop quotes by, and what to buy besides."""
    block, get, name = report["print"], parameters.get, report["name"]
    x, y, z = block["bbox_mm"]
    support = native.support_kind(parameters)
    own = 0.0 if support.soluble else block["support_volume_cm3"]  # of the tiles' own material
    rigid = block["tile_volume_cm3"] + block["anchor_volume_cm3"] + own
    printer = read_printer(get("printer"))
    bed = " × ".join(f"{side:g}" for side in printer["bed_mm"])
    soft = block["support_volume_cm3"] - own
    materials = "two materials: " if support.soluble and soft > 0 else "one material: "
    return [
        ("Quantity", f"{quantity}, each of {block['bodies']} bodies ({report['tiles']} tiles) in "
                     f"{block['pieces']} separate piece{'s' * (block['pieces'] > 1)}"),
        ("To be printed", f"{name}-print.3mf or {name}-print.step: every body with its name, in place; "
                          "or the files of tiles, anchors and support, which share one origin"),
        ("Size", f"{x:.1f} × {y:.1f} × {z:.1f} mm"),
        ("Material", materials + printer["material_class"]
         + (", and support that a bath dissolves" if support.soluble and soft > 0 else "")),
        ("Rigid material", f"{rigid:.1f} cm³, {rigid * get('density'):.0f} g at "
                           f"{get('density'):g} g/cm³ (tiles {block['tile_volume_cm3']:.1f} cm³, anchors "
                           f"{block['anchor_volume_cm3']:.1f} cm³"
                           + (f", {support.bodies} {own:.1f} cm³)" if own else ")")),
        ("Support material", f"{soft:.1f} cm³" + (" (soluble)" if support.soluble else "")
         + ("; the slicer's supports under tiles that reach out come on top"
            if overhangs(block["overhang_mm"], parameters, printer) else "")),
        ("Layer, tolerance", f"{printer['layer_mm']:g} mm or less, ± {printer['tolerance_mm']:g} mm"),
        ("Finish", printer["finish"]),
        ("Orientation", f"{_SIDES[get('orientation')]}, as the files stand; support is printed with the "
                        "parts"),
        ("Printer compared with", f"{printer['name']}: bed {bed} mm, "
         + ("the print fits" if fits_bed(block["bbox_mm"], printer) else "the print does not fit")),
        ("Smallest feature", f"{block['smallest_feature_mm']:.3g} mm; the printer makes "
                             f"{printer['smallest_feature_mm']:g} mm"),
        ("Least clearance between tiles", f"{show(report['solids']['min_clearance_flat_mm'])} mm; the "
                                          f"printer needs {printer['smallest_gap_mm']:g} mm"),
    ]


def latex(report: Mapping[str, Any], parameters: Any) -> str:
    """What to buy for the membranes."""
    get, sheets = parameters.get, report["sheets"]
    x, y = sheets["cut_mm"]
    thickness = {get("thickness_front"), get("thickness_back")}
    modulus = {get("shear_modulus_front"), get("shear_modulus_back")}
    return (f"two sheets of latex, {_either(thickness)} mm thick, shear modulus {_either(modulus)} MPa, each "
            f"cut to {x:.0f} × {y:.0f} mm, of which {sheets['grip_mm']:g} mm around are for the grip")


def print_picture(results: Results) -> Optional[Picture]:
    """All that is printed, where there are solids."""
    if not has_solids(results):
        return None
    model, printer = results["solids"].model, read_printer(results.parameters.get("printer"))
    return Picture("", "All that is printed, seen from above: tiles, anchors with the label, and what holds "
                       "them together.", "print",
                   {"model": model, "bed": printer["bed_mm"]})


def _either(values: set[float]) -> str:
    """One number, or the front's and the back's."""
    return " and ".join(f"{value:g}" for value in sorted(values))
