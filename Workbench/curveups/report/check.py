# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the answer of `curveups check`: check.json, check.html and the table on standard output."""

from __future__ import annotations

from typing import Any, Callable, Sequence

import numpy as np

from ..base.errors import tile_name
from ..base.findings import Finding
from ..base.sentences import ESTIMATE
from ..project.project import Results
from ..stages.feasibility import Obstacle, TileFigure
from . import data, html

FORMAT, VERSION = "curveups-check", 1
Row = tuple[str, str, str, str, str]


def build_check(results: Results) -> dict[str, Any]:
    """check.json. Dihedral angles and their margins are in degrees; numbers that there are
    none of (no back face, no flat map) are NaN here and null in the file."""
    found, sizes = results["feasibility"], results["sizes"]
    get = results.parameters.get
    return {
        "format": FORMAT, "version": VERSION, "name": results.name, "feasible": found.feasible,
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
                    for one in found.blocked],
        "trimmed": found.trimmed.tolist(), "overlapping": found.overlapping.tolist(),
        "pins_meeting": found.meeting.tolist(), "relieved_pin_sides": found.reached,
        "recommended": {"L": list(sizes.L) if sizes.L else None, "H_body": sizes.H_body},
    }


def verdict(results: Results) -> list[Finding]:
    """What is in the way."""
    found = results["feasibility"]
    sure = sorted({one.tile for one in found.blocked if one.certain})
    likely = sorted({one.tile for one in found.blocked} - set(sure))
    said = [Finding.about(kind, tiles, at=tuple(tiles), count=len(tiles), of=len(found.F))
            for kind, tiles in (("check.blocked", sure), ("check.likely", likely)) if tiles]
    return said or [Finding("check.clear")]


def rows(results: Results) -> list[Row]:
    """What is compared, the worst value, the tile that has it, what is wanted, how many tiles miss that."""
    return [row(figure, results["feasibility"].blocked) for figure in results["feasibility"].figures]


def row(figure: TileFigure, blocked: Sequence[Obstacle], number: Callable[[float, str], str] = format) -> Row:
    """number: writes a value of the figure, and how Python does."""
    worst, wanted = figure.worst(), number(figure.needed, "g") + " *" * figure.estimate
    value, tile = ("-", "") if worst is None else (number(figure.values[worst], ".3g"), tile_name(worst))
    return figure.name, value, tile, wanted, str(figure.short(blocked))


def advice(results: Results) -> list[Finding]:
    """On the limits of sizes."""
    get = results.parameters.get
    return list(results["sizes"].findings(get("L"), get("H_body")))


def _reasons(blocked: Sequence[Obstacle]) -> list[str]:
    """The first obstacle of each kind, and how many tiles have one; certain ones before estimates."""
    groups: dict[tuple[bool, str], list[Obstacle]] = {}
    for one in sorted(blocked, key=lambda one: not one.certain):
        groups.setdefault((one.certain, one.obstacle), []).append(one)
    lines = []
    for (certain, _), found in groups.items():
        tiles = len({one.tile for one in found})
        lines.append(f"{tile_name(found[0].tile)}: {found[0].why}" + " *" * (not certain)
                     + f" ({tiles} tiles)" * (tiles > 1))
    return lines


HEAD = ("", "worst", "tile", "wanted", "tiles short")


def table(results: Results) -> list[str]:
    """Lines for a terminal, on margins and what is in the way."""
    found, get = results["feasibility"], results.parameters.get
    lines = [f"{results.name}: {len(found.F)} tiles, L = {get('L'):.4g} mm, H_body = {get('H_body'):g} mm"]
    for what, value, tile, wanted, short in (HEAD, *rows(results)):
        lines.append(f"  {what:<42}{value:>9}  {tile:<8}{wanted:>7}  {short:>11}")
    return [*lines, f"  {ESTIMATE}", ", ".join(map(str, verdict(results))),
            *(f"  {line}" for line in _reasons(found.blocked))]


def build_page(results: Results) -> str:
    """check.html."""
    found = results["feasibility"]
    blocked = found.blocked
    kind, word = ("valid", "Feasible") if not blocked else ("invalid", "Not feasible")
    said = "".join(f"<li>{html.escape(str(line))}</li>" for line in (*verdict(results), *advice(results)))
    parts = [f"<h1>{html.escape(results.title)}</h1>",
             f'<p><span class="verdict {kind}">{word}</span> &nbsp; {len(found.F)} tiles</p><ul>{said}</ul>',
             *html.pictured("blocked", "The target from both sides: tiles that can't be made in red, those "
                            "that are likely to fail in orange.",
                            V=found.V, F=found.F, marks=_marks(len(found.F), blocked)),
             "<h2>Margins</h2>", data.table(rows(results), HEAD), f'<p class="note">{ESTIMATE}</p>']
    if blocked:
        parts += ["<h2>Obstacles</h2>",
                  data.table([(tile_name(one.tile), str(one.why), "certain" if one.certain else "estimate")
                              for one in blocked[:_MOST_LISTED]], ("Tile", "Why", ""))]
        if len(blocked) > _MOST_LISTED:
            parts.append(f'<p class="note">and {len(blocked) - _MOST_LISTED} more, in check.json</p>')
    return html.page(results.title, parts)


_MOST_LISTED = 200


def _marks(count: int, blocked: Sequence[Obstacle]) -> np.ndarray:
    """For each of so many tiles: 0, or 1 where it is likely to fail, 2 where it can't be made."""
    marks = np.zeros(count, int)
    for one in blocked:
        marks[one.tile] = max(marks[one.tile], 2 if one.certain else 1)
    return marks
