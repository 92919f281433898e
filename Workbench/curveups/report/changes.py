# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows in report.html what mending, feasibility smoothing and repair did, and the contacts that are nearest
to failing."""

from __future__ import annotations

from html import escape
from typing import Any, Mapping, Sequence

from ..base.errors import tile_list, tile_name
from .tables import show, table

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
    if not contacts:
        return []
    rows = [(_pair(one["tiles"]), one["normal_min"], one["normal_min"] / f_min if f_min else None,
             one["normal_mean"], one["friction_ratio"]) for one in contacts]
    return ["<h2>Worst contacts</h2>",
            table(rows, ("Tiles", "Least normal force, N", "in units of f_min", "Mean normal force, N",
                         "Friction / normal force"))]


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
