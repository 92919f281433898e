# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the answer of `curveups check`: check.json, check.html and the table on standard output."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from ..base.errors import tile_name
from ..base.findings import Finding
from ..base.sentences import ESTIMATE, MARGINS
from ..project.project import Results
from ..stages.advice import of_check
from ..stages.feasibility import SAG, TOO_NARROW, TOO_SLACK, Obstacle
from ..stages.trial import REPAIR_STEPS
from . import html, tables

FORMAT, VERSION = "curveups-check", 1
Row = tuple[str, str, str, str, str]


def build_check(results: Results) -> dict[str, Any]:
    """check.json. Dihedral angles and their margins are in degrees; numbers that there are
    none of (no back face, no flat map) are NaN here and null in the file."""
    found, sizes, tried = results["feasibility"], results["sizes"], results["trial layout"]
    get = results.parameters.get
    return {
        "format": FORMAT, "version": VERSION, "name": results.name, "feasible": tried.feasible,
        "trial": tried.shown or None, "trial_not_valid": list(map(str, tried.beyond)),
        "L": get("L"), "H_body": get("H_body"), "H_pin": get("H_pin"),
        "tiles": [{"tile": i, "fold_margin": float(found.least_dihedral_margin[i]),
                   "back_scale": float(found.back_scale[i]),
                   "pin_room_mm2": found.pin_area_margin[i].tolist(),
                   "membrane_room_mm": found.membrane_clearance[i].tolist(),
                   "stretch": float(found.stretch[i]), "stretch_range": found.stretch_range[i].tolist()}
                  for i in range(len(found.F))],
        "contacts": [{"tiles": pair, "fold_deg": float(dihedral), "fold_margin": float(margin),
                      "interface": float(share)}
                     for pair, dihedral, margin, share in zip(
                         found.contacts.tolist(), found.dihedral, found.dihedral_margin,
                         found.interface_share)],
        "blocked": [{"tile": one.tile, "why": str(one.why), "obstacle": one.obstacle, "certain": one.certain}
                    for one in tried.blocked],
        "trimmed": found.trimmed.tolist(), "overlapping": found.overlapping.tolist(),
        "pins_meeting": found.meeting.tolist(),
        "relieved_pin_sides": found.reached, "mending_would_move_mm": sizes.mending,
        "recommended": {"L": list(sizes.L) if sizes.L else None, "H_body": sizes.H_body,
                        "H_pin": sizes.H_pin,
                        "together": (dict(zip(("H_body", "H_pin"), sizes.together)) if sizes.together
                                     else None),
                        "not_valid": {name: list(map(str, why)) for name, why in sizes.beyond.items()}},
        "tried": [{"L": L, "H_body": H_body, "H_pin": H_pin, "tiles": tiles, "feasible": feasible}
                  for L, H_body, H_pin, tiles, feasible in sizes.tried],
    }


def verdict(results: Results) -> list[Finding]:
    """What is in the way."""
    found = results["trial layout"]
    sure = sorted({one.tile for one in found.blocked if one.certain})
    likely = sorted({one.tile for one in found.blocked} - set(sure))
    said = [Finding.about(kind, tiles, at=tuple(tiles), count=len(tiles), of=len(results["feasibility"].F))
            for kind, tiles in (("check.blocked", sure), ("check.likely", likely)) if tiles]
    tried = [Finding.about(f"check.{found.shown}", steps=REPAIR_STEPS)] if found.shown else []
    beyond = [Finding.about("check.passed_beyond", reasons=found.beyond)] if found.beyond else []
    return [*(said or [Finding("check.clear")]), *tried, *beyond]


def rows(results: Results) -> list[Row]:
    """What is compared, the worst value, the tile that has it, what is wanted, how many tiles miss that."""
    found, blocked = results["feasibility"], results["trial layout"].blocked
    short = {kind: len({one.tile for one in blocked if one.obstacle == kind})
             for kind in ("fold", "pin", "overlap", "closed", "membrane", "stretch")}
    least, floor, height = map(results.parameters.get, ("A_pin_min", "A_pin_floor", "H_pin"))
    with np.errstate(divide="ignore", invalid="ignore"):  # where not even the smallest pins hold a membrane
        low, high = (found.stretch[:, None] / found.stretch_range).T
    sides = list(enumerate(("front", "back")))
    table = [_row(found.least_dihedral_margin, "0", short["fold"]),
             _row(found.back_scale, "0", short["fold"]),
             *(_row(found.pin_area_margin[:, side] + least, f"{floor:g}",
                    sum(one.is_at("pin", name) for one in blocked)) for side, name in sides),
             *(_row(found.membrane_clearance[:, side], f"{SAG * height:g} *",
                    sum(one.is_at("membrane", name) for one in blocked)) for side, name in sides),
             _row(low, f"{TOO_NARROW:g} *", short["stretch"]),
             _row(high, f"{TOO_SLACK:g} *", short["stretch"], True),
             (str(len(found.overlapping) + len(found.meeting)), "", "0", str(short["overlap"]))]
    return [(what, *cells) for what, cells in zip(MARGINS, table)]


def _row(values: np.ndarray, wanted: str, short: int, most: bool = False) -> tuple[str, str, str, str]:
    known = np.flatnonzero(~np.isnan(values))
    if not len(known):
        return "-", "", wanted, str(short)
    worst = int(known[(np.argmax if most else np.argmin)(values[known])])
    return f"{values[worst]:.3g}", tile_name(worst), wanted, str(short)


def advice(results: Results) -> list[Finding]:
    """On sizes that would do, and on mending."""
    get = results.parameters.get
    return list(of_check(results["sizes"], get("L"), get("H_body")))


def _said(results: Results) -> list[str]:
    return [", ".join(map(str, verdict(results))), *map(str, advice(results))]


def _reasons(results: Results) -> list[str]:
    """The first obstacle of each kind, and how many tiles have one; certain ones before estimates."""
    groups: dict[tuple[bool, str], list[Obstacle]] = {}
    for one in sorted(results["trial layout"].blocked, key=lambda one: not one.certain):
        groups.setdefault((one.certain, one.obstacle), []).append(one)
    lines = []
    for (certain, _), found in groups.items():
        tiles = len({one.tile for one in found})
        lines.append(f"{tile_name(found[0].tile)}: {found[0].why}" + " *" * (not certain)
                     + f" ({tiles} tiles)" * (tiles > 1))
    return lines


HEAD = ("", "worst", "tile", "wanted", "tiles short")


def table(results: Results) -> list[str]:
    """Lines for a terminal."""
    found, get = results["feasibility"], results.parameters.get
    lines = [f"{results.name}: {len(found.F)} tiles, L = {get('L'):.4g} mm, H_body = {get('H_body'):g} mm"]
    for what, value, tile, wanted, short in (HEAD, *rows(results)):
        lines.append(f"  {what:<42}{value:>9}  {tile:<8}{wanted:>7}  {short:>11}")
    met, *more = _said(results)
    return [*lines, f"  {ESTIMATE}", met, *(f"  {line}" for line in _reasons(results)), *more]


def build_page(results: Results) -> str:
    """check.html."""
    found, blocked = results["feasibility"], results["trial layout"].blocked
    kind, word = ("valid", "Feasible") if not blocked else ("invalid", "Not feasible")
    said = "".join(f"<li>{html.escape(line)}</li>" for line in _said(results))
    parts = [f"<h1>{html.escape(results.title)}</h1>",
             f'<p><span class="verdict {kind}">{word}</span> &nbsp; {len(found.F)} tiles</p><ul>{said}</ul>',
             *html.pictured("blocked", "The target from both sides: tiles that can't be made in red, those "
                            "that are likely to fail in orange.",
                            V=found.V, F=found.F, marks=_marks(len(found.F), blocked)),
             "<h2>Margins</h2>", tables.table(rows(results), HEAD), f'<p class="note">{ESTIMATE}</p>']
    if blocked:
        parts += ["<h2>Obstacles</h2>",
                  tables.table([(tile_name(one.tile), str(one.why), "certain" if one.certain else "estimate")
                                for one in blocked[:_MOST_LISTED]], ("Tile", "Why", ""))]
        if len(blocked) > _MOST_LISTED:
            parts.append(f'<p class="note">and {len(blocked) - _MOST_LISTED} more, in check.json</p>')
    parts += ["<h2>Sizes tried</h2>",
              tables.table([(L, H_body, H_pin, tiles or None, feasible)
                            for L, H_body, H_pin, tiles, feasible in results["sizes"].tried],
                           ("L, mm", "H_body, mm", "H_pin, mm", "Tiles", "Feasible")),
              '<p class="note">By estimates, and by trial layouts of what was to be named.</p>']
    return html.page(results.title, parts)


_MOST_LISTED = 200


def _marks(count: int, blocked: Sequence[Obstacle]) -> np.ndarray:
    """For each of so many tiles: 0, or 1 where it is likely to fail, 2 where it can't be made."""
    marks = np.zeros(count, int)
    for one in blocked:
        marks[one.tile] = max(marks[one.tile], 2 if one.certain else 1)
    return marks
