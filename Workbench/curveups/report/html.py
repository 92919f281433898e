# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: one file with pictures and tables that needs nothing beside it."""

from __future__ import annotations

import base64
from html import escape
from importlib import import_module
from typing import Any, Iterable, Mapping, Optional, Sequence, Union

from ..base.errors import tile_list, tile_name
from ..base.parameters import table as parameter_table
from ..project.project import HOLDS, Results
from ..stages.actuation import states
from .assembly import steps
from .data import show, table
from .shop import latex, print_picture, quote, rules

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


Drawn = Union[bytes, str]  # PNG, or HTML of what moves
# Modules and their functions. matplotlib is loaded where the first picture is drawn.
_VIEWS = {"flat": ("pictures", "flat_layout"), "actuated": ("pictures", "actuated_view"),
          "cuts": ("pictures", "cut_view"), "stretch": ("pictures", "stretch_view"),
          "movement": ("pictures", "movement_view"),
          "distance": ("pictures", "distance_view"), "blocked": ("pictures", "blocked_view"),
          "moving": ("actuation", "moving_view"), "print": ("print_pictures", "print_view")}


def view(name: str, **data: Any) -> Drawn:
    """A picture."""
    module, function = _VIEWS[name]
    return getattr(import_module(f".{module}", __package__), function)(**data)


def pictured(name: str, caption: str, **data: Any) -> list[str]:
    """A picture with its caption, as parts of a page."""
    return [picture(view(name, **data), caption)]


def build_html(results: Results, report: dict) -> str:
    """Page for the results of a run and their report."""
    parts = [f"<h1>{escape(report['title'])}</h1>", _verdict(report)]
    printed = "print" in report and "sheets" in report
    parts += _shop(report, results.parameters) if printed else []
    of_print = print_picture(results)  # belongs to the shop's block
    for one in (*([of_print] if of_print else []), *results.pictures()):
        parts += [f"<h2>{escape(one.heading)}</h2>"] if one.heading else []
        parts += pictured(one.view, one.caption, **one.data)
    parts += _cuts(report.get("suggested_cuts", ()))
    parts += changes(report)
    parts += worst_contacts(report.get("worst_contacts", ()),
                            report.get("contact_forces", {}).get("f_min", 0.0))
    parts += _pieces(report.get("pieces", ()))
    parts += _window(report.get("window", ()))
    if printed:
        parts += ["<h2>Assembly</h2>", list_of(steps(report, results.parameters))]
    parts += ["<h2>Figures</h2>", _figures(report)]
    if report["warnings"]:
        parts += ["<h2>Warnings</h2>", _warnings(report["warnings"])]
    parts += ["<h2>Parameters</h2>", _parameters(results.parameters.to_dict())]
    return page(report["title"], parts)


def page(name: str, parts: Sequence[str], language: str = "en") -> str:
    """A whole page of these parts."""
    body = "\n".join(parts)
    return (f'<!DOCTYPE html>\n<html lang="{language}"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(name)} – CurveUps</title><style>{_STYLE}</style></head>\n"
            f"<body><main>\n{body}\n</main></body></html>\n")


def _verdict(report: dict) -> str:
    words = {True: ("valid", "Valid"), False: ("invalid", "Not valid"), None: ("open", "Not judged")}
    kind, text = words[report["valid"]]
    text += f", {HOLDS[report['holds']]}"
    if report["status"] == "stopped":
        text += ", stopped before the end"
    reasons = "".join(f"<li>{escape(reason)}</li>" for reason in report["reasons"])
    return (f'<p><span class="verdict {kind}">{text}</span> &nbsp; {report["tiles"]} tiles, '
            f'{report["contacts"]} contacts, {report["cuts"]} cuts</p>'
            + (f"<ul>{reasons}</ul>" if reasons else "")
            + "".join(f'<p class="note">Not covered: {escape(text)}.</p>'
                      for text in report.get("not_covered", ())))


def _section(heading: str, rows: Sequence[tuple[Any, ...]], head: tuple[str, ...]) -> list[str]:
    """A heading and a table; nothing without rows."""
    return [f"<h2>{heading}</h2>", table(rows, head)] if rows else []


def _window(ranges: Sequence[dict]) -> list[str]:
    """How far each parameter may be off, and what fails first beyond."""
    def beyond(end: Optional[dict]) -> str:
        return f"{end['what']} {tile_list(end['tiles'], 5)}".strip() if end else "nothing"

    rows = [(f"{_words(one['parameter'])}{', ' + one['unit'] if one['unit'] else ''}",
             *("any" if one[end] is None else one[end] for end in ("low", "high")),
             " to ".join(map(show, one["searched"])),
             *(beyond(one[end]) for end in ("fails_low", "fails_high")))
            for one in ranges]
    return _section("Process window", rows, ("Each alone", "From", "To", "Searched", "What fails below",
                                             "What fails above"))


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
    return _section("Pieces", rows, ("Piece", "Tiles", "Contacts", "Actuated, cm²", "Mean normal force, N",
                                     "Least, N", "f_min of its own mean, N", "Holds"))


def picture(drawn: Drawn, caption: str) -> str:
    """A picture inside of the page."""
    if isinstance(drawn, bytes):
        data = base64.b64encode(drawn).decode("ascii")
        drawn = f'<img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
    return f"<figure>{drawn}<figcaption>{escape(caption)}</figcaption></figure>"


def _shop(report: dict, parameters: Any) -> list[str]:
    """What the print shop reads first."""
    rows = [*quote(report, parameters), ("Membranes", latex(report, parameters))]
    files = [(file, f"{size / 1e6:.2f}") for file, size in sorted(report["print"]["files"].items())]
    return ["<h2>For the print shop</h2>", list_of(rules(report, parameters), "ul"), table(rows),
            '<p class="note">Lengths are in millimetres in every file.</p>', table(files, ("File", "MB"))]


def list_of(lines: Iterable[object], kind: str = "ol") -> str:
    """A numbered list, or one with dots."""
    return f"<{kind}>" + "".join(f"<li>{escape(str(line))}</li>" for line in lines) + f"</{kind}>"


# Units that names of figures do not end in.
_FORCES = ("normal_mean", "normal_min", "f_min", "floor", "largest_floor", "mean_tile_force")
_UNITS = {"mm": "mm", "mm2": "mm²", "mm3": "mm³", "cm2": "cm²", "cm3": "cm³"}


def _figures(report: dict) -> str:
    # Times and memory stay out: the same design gives the same page.
    parts = []
    for block in ("area", "constraints", "target", "deviation", "layout", "truncation", "physics",
                  "contact_forces", "unilateral", "settled", "margin",
                  "clearances", "solids"):
        rows = []
        for key, value in report.get(block, {}).items():
            if isinstance(value, dict):
                rows += [(f"{_words(key)}: {_words(inner)}", item) for inner, item in value.items()]
            elif key not in ("invalid_contacts", "open_contacts", "notes", "unit"):
                rows.append(_figure(key, value))
        if rows:
            parts += [f"<h3>{escape(_words(block).capitalize())}</h3>", table(rows)]
    if "actuation" in report:
        parts += ["<h3>From flat to shape</h3>", states_table(report["actuation"])]
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
                   tile_list(item.get("tiles", []), 12)) for item in warnings],
                 ("What", "Tiles"))


def _parameters(values: dict) -> str:
    return table([(row.group, row.name, values[row.name], row.unit, row.meaning)
                  for row in parameter_table()],
                 ("Group", "Name", "Value", "Unit", "Meaning"))


_MOST = 10  # rows of a table of moved vertices


def changes(report: Mapping[str, Any]) -> list[str]:
    """Sections on what was changed of the target and its tiles; none where nothing was."""
    parts: list[str] = []
    for heading, block, lines in (("Mending", "mending", _mending),
                                  ("Feasibility smoothing", "pin_smoothing", _pin_smoothing),
                                  ("Repair", "repair", _repair)):
        if block in report:
            parts += [f"<h3>{heading}</h3>", *lines(report[block], report)]
    return ["<h2>Changes</h2>", *parts] if parts else []


def worst_contacts(contacts: Sequence[Mapping[str, Any]], f_min: float) -> list[str]:
    """The contacts with the least normal force, of a valid design too."""
    rows = [(_pair(one["tiles"]), one["normal_min"], one["normal_min"] / f_min if f_min else None,
             one["normal_mean"], one["friction_ratio"]) for one in contacts]
    return _section("Worst contacts", rows, ("Tiles", "Least normal force, N", "in units of f_min",
                                             "Mean normal force, N", "Friction / normal force"))


def _mending(block: Mapping[str, Any], report: Mapping[str, Any]) -> list[str]:
    actions, remaining = block["actions"], block["remaining"]
    parts = [f"<p>{'The target was mended:' if actions else 'There was nothing to mend.'}</p>"]
    if actions:
        parts += ["<ul>", *(f"<li>{escape(action)}</li>" for action in actions), "</ul>",
                  table([("Vertices moved", block["moved_vertices"]),
                         ("Mean of these", _mm(block["mean_mm"])), ("Largest", _mm(block["max_mm"])),
                         ("Hausdorff distance between before and after", _mm(block["hausdorff_mm"]))])]
    if remaining:
        parts.append(f"<p>These tiles still have too little space: {tile_list(remaining, 12)}.</p>")
    return parts


def _mm(value: float) -> str:
    return f"{show(value)} mm"


def _pin_smoothing(block: Mapping[str, Any], report: Mapping[str, Any]) -> list[str]:
    sides = [(tile_name(one["tile"]), one["side"], one["area_before_mm2"]) for one in block["pin_sides"]]
    text = (f"Moving vertices gave pins more space: {_moved(block)}. {len(sides)} pin sides had less "
            f"than A_pin_min before, and {block['remaining']} still have less.")
    return [f"<p>{escape(text)}</p>", *_vertices(block),
            table(sides[:_MOST], ("Tile", "Side", "Largest pin before, mm²")), *_rest(len(sides))]


def _repair(block: Mapping[str, Any], report: Mapping[str, Any]) -> list[str]:
    ended = {"valid": "It ended with a valid design.", "stopped": "It was stopped.",
             "blocked": "It could not strengthen all contacts." if block["blocked"] or not block.get("cuts")
             else "It could not keep membranes from cutting into bodies."}[block["status"]]
    mended = [_pair(pair) for pair in block.get("mended", ())]
    text = (f"{ended} {len(block['steps'])} steps; corners and insets moved by up to "
            f"{show(block['largest_move_mm'])} mm in the layout; {_moved(block)}.")
    parts = [f"<p>{escape(text)}</p>"]
    if mended:
        shown = ", ".join(mended[:4 * _MOST])
        more = f" and {len(mended) - 4 * _MOST} more" if len(mended) > 4 * _MOST else ""
        parts.append(f"<p>{escape(f'These contacts were weak before: {shown}{more}.')}</p>")
    parts += _vertices(block)
    if block["blocked"]:
        parts.append(table([(_pair(one["tiles"]), one["reason"]) for one in block["blocked"][:_MOST]],
                           ("Contact that stays weak", "Why")))
        parts += _rest(len(block["blocked"]))
    return parts


def _moved(block: Mapping[str, Any]) -> str:
    moved = block.get("moved_vertices", ())
    if not moved:
        return "no vertex moved"
    return f"{len(moved)} vertices moved by up to {show(moved[0]['mm'])} mm"


def _vertices(block: Mapping[str, Any]) -> list[str]:
    moved = block.get("moved_vertices", ())
    if not moved:
        return []
    rows = [(one["vertex"], ", ".join(map(tile_name, one["tiles"])), one["mm"]) for one in moved[:_MOST]]
    return [table(rows, ("Vertex", "Tiles around it", "Moved by, mm")), *_rest(len(moved))]


def _rest(count: int) -> list[str]:
    return [f'<p class="note">{count - _MOST} more are in report.json.</p>'] if count > _MOST else []


def _pair(tiles: Sequence[int]) -> str:
    return "–".join(tile_name(tile) for tile in tiles)


WORDS = {"relaxed": "without friction",
         "by_itself": "released", "shaken": "shaken", "pressed": "pressed and let go"}


def states_table(block: Mapping[str, Any]) -> str:
    """States of a block of report.json, a row each."""
    rows = [(WORDS[name] if state["converged"] else f"{WORDS[name]}: no rest",
             *(state[key] for key in ("mean_mm", "rms_mm", "p95_mm", "max_mm", "hausdorff_mm")),
             len(state["open_contacts"]), state["energy_n_mm"]) for name, state in states(block).items()]
    return table(rows, ("State", "Mean, mm", "RMS, mm", "95 %, mm", "Largest, mm", "Hausdorff, mm",
                        f"Open of {block['contacts']} contacts", "Energy, N mm"))
