# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: one file with pictures and tables that needs nothing beside it."""

from __future__ import annotations

import base64
from importlib import import_module
from html import escape
from typing import Any, Callable, Iterable, Iterator, Optional, Sequence

from ..base.errors import tile_list, tile_name
from ..base.native import native
from ..base.parameters import table as parameter_table
from ..project.project import Results
from ..stages.solids import fits_bed, overhangs, read_printer
from .changes import changes, worst_contacts
from .tables import show, table

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #2b2620; background: #faf8f4; margin: 0; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; margin: 0 0 .3rem; } h2 { margin: 2.2rem 0 .6rem; font-size: 1.25rem; }
h3 { margin: 1.2rem 0 .3rem; font-size: 1rem; }
.verdict { display: inline-block; padding: .2rem .8rem; border-radius: 1rem; font-weight: 600; }
.valid { background: #d8efd9; color: #1c5a24; } .invalid { background: #f9dcd8; color: #8c1d12; }
.open { background: #eee6d4; color: #5d4a1d; }
table { border-collapse: collapse; width: 100%; background: #fff; }
td, th { padding: .3rem .7rem; border-bottom: 1px solid #e8e1d3; text-align: left;
  vertical-align: top; }
th { font-weight: 600; background: #f3ede0; } td { font-variant-numeric: tabular-nums; }
.pairs td:first-child { width: 32%; }
img { width: 100%; background: #fff; border: 1px solid #e8e1d3; border-radius: .4rem; }
figure { margin: 0; } figcaption { color: #6d6454; font-size: .9rem; }
.note { color: #6d6454; }
"""


# Modules and their functions. matplotlib is loaded where the first picture is drawn.
_VIEWS = {"flat": ("pictures", "flat_layout"), "actuated": ("pictures", "actuated_view"),
          "cuts": ("cut_pictures", "cut_view"), "stretch": ("membrane_pictures", "stretch_view"),
          "movement": ("pictures", "movement_view"), "blocked": ("pictures", "blocked_view")}


def view(name: str, **data: Any) -> bytes:
    """A picture, as PNG."""
    module, function = _VIEWS[name]
    return getattr(import_module(f".{module}", __package__), function)(**data)


def draw(results: Results) -> Iterator[bytes]:
    """The page's pictures in their order; they are most of its time."""
    for one in results.pictures():
        yield view(one.view, **one.data)


def pictures_or_note(draw: Callable[[], Iterable[bytes]]) -> tuple[list[bytes], list[str]]:
    """The pictures, or none and what the page says of that: a page without them is better than none."""
    try:
        return list(draw()), []
    except Exception as error:  # of matplotlib, which needs a folder that it may write to
        said = escape(" ".join(str(error).split()) or type(error).__name__)
        return [], [f'<p class="note">The pictures could not be drawn: {said}.</p>']


def build_html(results: Results, report: dict, drawn: Optional[Sequence[bytes]] = None) -> str:
    """The page for the results of a run and their report; `drawn`: its pictures, where they are there."""
    shown, note = pictures_or_note(lambda: draw(results) if drawn is None else drawn)
    parts = [f"<h1>{escape(report['title'])}</h1>", _verdict(report), *note]
    for one, png in zip(results.pictures(), shown):
        parts += [f"<h2>{escape(one.heading)}</h2>"] if one.heading else []
        parts.append(picture(png, one.caption))
    parts += _cuts(report.get("suggested_cuts", ()))
    parts += changes(report)
    parts += worst_contacts(report.get("worst_contacts", ()),
                            report.get("contact_forces", {}).get("f_min", 0.0))
    parts += _pieces(report.get("pieces", ()))
    if "print" in report:
        parts += ["<h2>For the print shop</h2>", _quote(report, results.parameters),
                  "<h2>Assembly</h2>", _assembly(report, results.parameters)]
    parts += ["<h2>Figures</h2>", _figures(report)]
    if report["warnings"]:
        parts += ["<h2>Warnings</h2>", _warnings(report["warnings"])]
    parts += ["<h2>Parameters</h2>", _parameters(results.parameters.to_dict())]
    return page(report["title"], parts)


def page(name: str, parts: Sequence[str]) -> str:
    """A whole page of these parts."""
    body = "\n".join(parts)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(name)} – CurveUps</title><style>{_STYLE}</style></head>\n"
            f"<body><main>\n{body}\n</main></body></html>\n")


def _verdict(report: dict) -> str:
    words = {True: ("valid", "Valid"), False: ("invalid", "Not valid"), None: ("open", "Not judged")}
    kind, text = words[report["valid"]]
    if report["status"] == "stopped":
        text += ", stopped before the end"
    reasons = "".join(f"<li>{escape(reason)}</li>" for reason in report["reasons"])
    unchecked = ", ".join(report.get("unchecked_files", ()))
    return (f'<p><span class="verdict {kind}">{text}</span> &nbsp; {report["tiles"]} tiles, '
            f'{report["contacts"]} contacts, {report["cuts"]} cuts</p>'
            + (f"<ul>{reasons}</ul>" if reasons else "")
            + "".join(f'<p class="note">Not covered: {escape(text)}.</p>'
                      for text in report.get("not_covered", ()))
            + (f'<p class="note">Files of solids that nobody has checked: {escape(unchecked)}.</p>'
               if unchecked else ""))


def _cuts(cuts: Sequence[dict]) -> list[str]:
    """Suggested cuts with their predicted effect."""
    rows = []
    for number, cut in enumerate(cuts, 1):
        before, after = cut["predicted"]["before"] or {}, cut["predicted"]["after"] or {}
        rows.append((number, "made" if cut["applied"] else "proposed", cut["reason"],
                     cut["length_mm"], *(f"{show(before.get(key))} → {show(after.get(key))}" for key in
                                         ("scale_spread", "area_ratio", "slack_springs"))))
    if not rows:
        return []
    return [table(rows, ("No.", "State", "Where", "Length, mm", "Spread of scale", "Flat / actuated area",
                         "Slack membrane at")),
            '<p class="note">Figures are predictions by draft layouts, each with the cuts before it '
            "made.</p>"]


def _pieces(pieces: Sequence[dict]) -> list[str]:
    """What is known of each piece for itself."""
    words = {True: "yes", False: "no", None: "not judged"}
    rows = [(one["piece"], f"{tile_name(one['first_tile'])} and {one['tiles'] - 1} more", one["contacts"],
             one["actuated_cm2"], one["normal_mean"], one["normal_min"], one["f_min"], words[one["valid"]])
            for one in pieces]
    if not rows:
        return []
    return ["<h2>Pieces</h2>",
            table(rows, ("Piece", "Tiles", "Contacts", "Actuated, cm²", "Mean normal force, N", "Least, N",
                         "f_min of its own mean, N", "Holds"))]


def picture(png: bytes, caption: str) -> str:
    """A picture inside of the page."""
    data = base64.b64encode(png).decode("ascii")
    return (f'<figure><img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{escape(caption)}</figcaption></figure>")


def _quote(report: dict, parameters: Any) -> str:
    block, get, name = report["print"], parameters.get, report["name"]
    x, y, z = block["bbox_mm"]
    support = native.support_kind(parameters)
    own = 0.0 if support.soluble else block["support_volume_cm3"]  # of the tiles' own material
    rigid = block["tile_volume_cm3"] + block["anchor_volume_cm3"] + own
    printer = read_printer(get("printer"))
    bed = " × ".join(f"{side:g}" for side in printer["bed_mm"])
    moduli = {get("shear_modulus_front"), get("shear_modulus_back")}
    thicknesses = {get("thickness_front"), get("thickness_back")}
    rows = [
        ("To be printed", f"{name}-print.3mf or {name}-print.step: every body with its name, in place; "
                          "or the files of tiles, anchors and support, which share one origin"),
        ("Orientation", f"{_SIDES[get('orientation')]}, as the files stand; support is printed with the "
                        "parts"),
        ("Size", f"{x:.1f} × {y:.1f} × {z:.1f} mm"),
        ("Printer compared with", f"{printer['name']}: bed {bed} mm, "
         + ("the print fits" if fits_bed(block["bbox_mm"], printer) else "the print does not fit")),
        ("Bodies", f"{block['bodies']}, of which {report['tiles']} tiles; separate pieces: "
                   f"{block['pieces']}"),
        ("Rigid material", f"{rigid:.1f} cm³, {rigid * get('density'):.0f} g at "
                           f"{get('density'):g} g/cm³ (tiles {block['tile_volume_cm3']:.1f} cm³, anchors "
                           f"{block['anchor_volume_cm3']:.1f} cm³"
                           + (f", {support.bodies} {own:.1f} cm³)" if own else ")")),
        ("Support material", f"{block['support_volume_cm3'] - own:.1f} cm³"
         + (" (soluble)" if support.soluble else "")
         + ("; the slicer's supports under tiles that reach out come on top"
            if overhangs(block["overhang_mm"], parameters, printer) else "")),
        ("Smallest feature", f"{block['smallest_feature_mm']:.3g} mm; the printer makes "
                             f"{printer['smallest_feature_mm']:g} mm"),
        ("Least clearance between tiles", f"{show(report['solids']['min_clearance_flat_mm'])} mm; the "
                                          f"printer needs {printer['smallest_gap_mm']:g} mm"),
        ("Membranes", f"two sheets of latex, {_either(thicknesses)} mm thick, shear modulus "
                      f"{_either(moduli)} MPa, stretched to {get('tau'):g} times their length in both "
                      f"directions: at least {x / get('tau'):.0f} × {y / get('tau'):.0f} mm each before "
                      "stretching, and what the frame holds"),
    ]
    files = [(file, f"{size / 1e6:.2f}") for file, size in sorted(block["files"].items())]
    return (table(rows) + '<p class="note">Lengths are in millimetres in every file.</p>'
            + table(files, ("File", "MB")))


_SIDES = {"front-up": "front side up", "front-down": "front side down"}


def _assembly(report: dict, parameters: Any) -> str:
    """What is glued in which order, for whoever puts it together."""
    get, block = parameters.get, report["print"]
    glue, first = block["glue"], block["glue"]["first"]
    second = "back" if first == "front" else "front"
    on_bed = "back" if get("orientation") == "front-up" else "front"
    level = f"the slab lies level with the pins ({glue[f'{second}_support_mm2']:.0f} mm²)"
    away = native.support_kind(parameters).removal.format(second=second)
    before = ""
    if overhangs(block["overhang_mm"], parameters, read_printer(get("printer"))):
        level = "the slicer's supports lie level with the pins"
        if on_bed == second:
            away = f"peel the slicer's supports off the {on_bed}" + (f", {away}" if away else "")
        else:
            before = (f"Peel the slicer's supports off the {on_bed}, tile by tile: {level} there. Bridges "
                      "alone hold the tiles meanwhile, and break easily.")
    steps = [
        f"Stretch both membranes to {get('tau'):g} times their length.",
        before,
        f"Glue the {first} first: its pins and anchors alone stand out there "
        f"({glue[f'{first}_pins_mm2'] + glue[f'{first}_anchors_mm2']:.0f} mm²)"
        + (f"; on the {second} {level} and would be glued along."
           if glue[f"{second}_support_mm2"] or "peel" in away else "."),
        f"Once the glue holds, turn the sheet over{', ' * bool(away)}{away}.",
        f"Glue the {second} pins and the other end of the anchors ("
        f"{glue[f'{second}_pins_mm2'] + glue[f'{second}_anchors_mm2']:.0f} mm²), lay the second membrane on.",
        "Take the sheet off the plates when the glue holds: it pulls itself into shape.",
        "Cut the anchors off with the surplus membrane; trim along rims, holes and cuts.",
        *_joining(block["pieces"], report.get("joints")),
    ]
    printed = "FRONT" if get("orientation") == "front-up" else "BACK"
    note = (f"The label beside an anchor of each piece says {printed} on that side."
            if get("anchors") and get("engrave") else "")
    return ("<ol>" + "".join(f"<li>{escape(step)}</li>" for step in steps if step) + "</ol>"
            + (f'<p class="note">{note}</p>' if note else ""))


def _joining(pieces: int, joints: Optional[dict]) -> Sequence[str]:
    """The steps after those of one piece."""
    if pieces < 2:
        return ()
    apart = f"Cut the {pieces} pieces apart where the membranes join them: each holds its shape by itself."
    if not joints or not joints["holes"]:
        return (apart, "Nothing joins the pieces: tape or glue them along their borders.")
    return (apart,
            "Bring pieces together in shape and sew them along their borders: through the membrane into "
            f"a stitching hole ({joints['hole_mm']:g} mm), out at its other side, and back through the hole "
            f"that faces it in the other piece; {joints['holes']} holes in all. "
            "A drop of glue around a hole keeps the membrane from tearing on. Pull the thread tight when all "
            "stitches are in.")


def _either(values: set[float]) -> str:
    """One number, or the front's and the back's."""
    return " and ".join(f"{value:g}" for value in sorted(values))


# Units that names of figures do not end in.
_FORCES = ("normal_mean", "normal_min", "f_min", "floor", "largest_floor", "mean_tile_force",
           "largest_floor_at_bump_tips")
_UNITS = {"mm": "mm", "mm2": "mm²", "mm3": "mm³", "cm2": "cm²", "cm3": "cm³"}


def _figures(report: dict) -> str:
    # Times and memory stay out: the same design gives the same page.
    parts = []
    for block in ("area", "constraints", "target", "deviation", "layout", "truncation", "physics",
                  "contact_forces", "unilateral", "clearances", "solids"):
        rows = []
        for key, value in report.get(block, {}).items():
            if isinstance(value, dict):
                rows += [(f"{_words(key)}: {_words(inner)}", item) for inner, item in value.items()]
            elif key not in ("invalid_contacts", "notes", "unit"):
                rows.append(_figure(key, value))
        if rows:
            parts += [f"<h3>{escape(_words(block).capitalize())}</h3>", table(rows)]
    return "".join(parts)


def _figure(key: str, value: Any) -> tuple[str, str]:
    stem, _, end = key.rpartition("_")
    if end in _UNITS:
        return _words(stem), f"{show(value)} {_UNITS[end]}"
    return _words(key), f"{show(value)}{' N' if key in _FORCES else ''}"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _warnings(warnings: list[dict]) -> str:
    return table([(item["what"] + (f" – {item['remedy']}" if item.get("remedy") else ""),
                   tile_list(item.get("tiles", []), 12)) for item in warnings[:200]],
                 ("What", "Tiles"))


def _parameters(values: dict) -> str:
    return table([(row.group, row.name, values[row.name], row.unit, row.meaning)
                  for row in parameter_table()],
                 ("Group", "Name", "Value", "Unit", "Meaning"))
