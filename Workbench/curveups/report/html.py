# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: one file with pictures and tables that needs nothing beside it."""

from __future__ import annotations

import base64
from html import escape
from typing import Any

import numpy as np

from ..errors import tile_list
from ..native import native
from . import pictures

_STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #2b2620; background: #faf8f4; margin: 0; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; margin: 0 0 .3rem; } h2 { margin: 2.2rem 0 .6rem; font-size: 1.25rem; }
.verdict { display: inline-block; padding: .2rem .8rem; border-radius: 1rem; font-weight: 600; }
.valid { background: #d8efd9; color: #1c5a24; } .invalid { background: #f9dcd8; color: #8c1d12; }
.open { background: #eee6d4; color: #5d4a1d; }
table { border-collapse: collapse; width: 100%; background: #fff; }
td, th { padding: .3rem .7rem; border-bottom: 1px solid #e8e1d3; text-align: left; vertical-align: top; }
th { font-weight: 600; background: #f3ede0; } td.n { text-align: right; font-variant-numeric: tabular-nums; }
img { width: 100%; background: #fff; border: 1px solid #e8e1d3; border-radius: .4rem; }
figure { margin: 0; } figcaption { color: #6d6454; font-size: .9rem; }
.note { color: #6d6454; }
"""


def build_html(outcome: Any, report: dict) -> str:
    """The page for an outcome and its report."""
    design = outcome.design
    parts = [
        f"<h1>{escape(report['name'])}</h1>",
        _verdict(report),
        "<h2>Actuated</h2>",
        _picture(pictures.actuated_view(design), "The tiles in the target shape, front side light."),
        "<h2>Flat layout</h2>",
        _picture(pictures.flat_layout(design),
                 "As it is printed, front side up; the pins that carry the membrane in dark."),
    ]
    parts += _physics_pictures(outcome)
    if "print" in report:
        parts += ["<h2>For the print shop</h2>", _quote(report, design)]
    parts += ["<h2>Figures</h2>", _figures(report)]
    if report["warnings"]:
        parts += ["<h2>Warnings</h2>", _warnings(report["warnings"])]
    parts += ["<h2>Parameters</h2>", _parameters(design.parameters.to_dict())]
    body = "\n".join(parts)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{escape(report['name'])} – CurveUps</title><style>{_STYLE}</style></head>\n"
            f"<body><main>\n{body}\n</main></body></html>\n")


def _verdict(report: dict) -> str:
    words = {True: ("valid", "Valid"), False: ("invalid", "Not valid"), None: ("open", "Not judged")}
    kind, text = words[report["valid"]]
    if report["status"] == "stopped":
        text += ", stopped before the end"
    reasons = "".join(f"<li>{escape(reason)}</li>" for reason in report["reasons"])
    return (f'<p><span class="verdict {kind}">{text}</span> &nbsp; {report["tiles"]} tiles, '
            f'{report["contacts"]} contacts, {report["cuts"]} cuts</p>'
            + (f"<ul>{reasons}</ul>" if reasons else ""))


def _physics_pictures(outcome: Any) -> list[str]:
    """Forces and friction as colour on the layout, where they were computed."""
    found = outcome.verification
    if found is None or not len(found.contact_tiles):
        return []
    design = outcome.design
    friction = np.zeros(len(design.F))
    for column in range(2):
        np.maximum.at(friction, found.contact_tiles[:, column], found.contact_friction_ratio)
    weak = [tuple(pair) for pair in found.blocks["contact_forces"]["invalid_contacts"]]
    marked = " Contacts below f_min are marked." if weak else ""
    return ["<h2>Contact forces</h2>",
            _picture(pictures.flat_layout(design, np.asarray(found.tile_normal_force), "N", weak),
                     f"Least normal force at each tile's contact points.{marked}"),
            _picture(pictures.flat_layout(design, friction, "friction / normal force", weak),
                     f"Largest friction that any of a tile's contacts needs.{marked}")]


def _picture(png: bytes, caption: str) -> str:
    data = base64.b64encode(png).decode("ascii")
    return (f'<figure><img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{escape(caption)}</figcaption></figure>")


def _table(rows: list[tuple[str, Any]], head: tuple[str, ...] = ()) -> str:
    top = "<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>" if head else ""
    lines = []
    for row in rows:
        cells = "".join(f'<td{" class=n" if _is_number(cell) else ""}>{escape(_show(cell))}</td>'
                        for cell in row)
        lines.append(f"<tr>{cells}</tr>")
    return f"<table>{top}{''.join(lines)}</table>"


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _show(value: Any) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.4g}" if abs(value) < 1e5 else f"{value:.0f}"
    if isinstance(value, (list, tuple)):
        return " × ".join(_show(item) for item in value)
    return str(value)


def _quote(report: dict, design: Any) -> str:
    block, get = report["print"], design.parameters.get
    rows = [
        ("Bounding box, mm", block["bbox_mm"]),
        ("Bodies", block["bodies"]), ("Pieces", block["pieces"]),
        ("Volume of tiles, cm3 (rigid material)", block["tile_volume_cm3"]),
        (f"Volume of support, cm3 ({get('support')})", block["support_volume_cm3"]),
        ("Volume of anchors, cm3 (rigid material)", block["anchor_volume_cm3"]),
        ("Smallest feature, mm", block["smallest_feature_mm"]),
        ("Least clearance between bodies, mm", report["solids"]["min_clearance_flat_mm"]),
        ("Printer compared with", get("printer")),
        ("Membranes", f"two latex sheets, stretched to {get('tau'):g} times their length"),
        ("Orientation", "front side up, as the file stands; support is built with the parts"),
    ]
    files = [(name, size) for name, size in sorted(block["files"].items())]
    return (_table(rows) + '<p class="note">Lengths are in millimetres in every file.</p>'
            + _table(files, ("File", "Bytes")))


def _figures(report: dict) -> str:
    # Times and memory stay out: the same design gives the same page.
    rows = []
    for block in ("area", "constraints", "target", "deviation", "layout", "truncation", "physics",
                  "contact_forces", "unilateral", "solids"):
        for key, value in report.get(block, {}).items():
            if isinstance(value, dict):
                rows += [(f"{block} {key} {inner}", item) for inner, item in value.items()]
            elif key not in ("invalid_contacts", "notes"):
                rows.append((f"{block} {key}".replace("_", " "), value))
    return _table(rows)


def _warnings(warnings: list[dict]) -> str:
    return _table([(item["what"] + (f" – {item['remedy']}" if item.get("remedy") else ""),
                    tile_list(item.get("tiles", []), 12)) for item in warnings[:200]],
                  ("What", "Tiles"))


def _parameters(values: dict) -> str:
    return _table([(row.group, row.name, values[row.name], row.unit, row.meaning)
                   for row in native.parameter_table()],
                  ("Group", "Name", "Value", "Unit", "Meaning"))
