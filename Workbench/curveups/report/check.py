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
from ..stages.stage import Picture
from . import html

FORMAT, VERSION = "curveups-check", 1
_MOST_LISTED = 200  # obstacles on the page
Row = tuple[str, str, str, str, str]


def build_check(results: Results) -> dict[str, Any]:
    """check.json. Dihedral angles and their margins are in degrees; numbers that there are
    none of (no back face, no flat map) are NaN here and null in the file."""
    feasibility, sizes = results["feasibility"], results["sizes"]
    get = results.parameters.get
    return {
        "format": FORMAT, "version": VERSION, "name": results.name, "feasible": feasibility.feasible,
        "L": get("L"), "H_body": get("H_body"), "H_pin": get("H_pin"),
        "tiles": [{"tile": i, "fold_margin": float(feasibility.least_dihedral_margin[i]),
                   "back_scale": float(feasibility.back_scale[i]),
                   "pin_room_mm2": feasibility.pin_area_margin[i].tolist(),
                   "membrane_room_mm": feasibility.membrane_clearance[i].tolist(),
                   "stretch": float(feasibility.stretch[i]),
                   "stretch_range": feasibility.stretch_range[i].tolist()}
                  for i in range(len(feasibility.F))],
        "contacts": [{"tiles": pair, "fold_deg": float(dihedral), "fold_margin": float(margin)}
                     for pair, dihedral, margin in zip(feasibility.contacts.tolist(), feasibility.dihedral,
                                                       feasibility.dihedral_margin)],
        "blocked": [{"tile": obstacle.tile, "why": str(obstacle.why), "obstacle": obstacle.obstacle,
                     "certain": obstacle.certain}
                    for obstacle in feasibility.blocked],
        "recommended": {"L": list(sizes.L) if sizes.L else None, "H_body": sizes.H_body},
    }


def verdict(results: Results) -> list[Finding]:
    """Findings on the obstacles of a target."""
    feasibility = results["feasibility"]
    sure = sorted({obstacle.tile for obstacle in feasibility.blocked if obstacle.certain})
    likely = sorted({obstacle.tile for obstacle in feasibility.blocked} - set(sure))
    findings = [Finding.about(kind, tiles, at=tuple(tiles), count=len(tiles), of=len(feasibility.F))
                for kind, tiles in (("check.blocked", sure), ("check.likely", likely)) if tiles]
    findings += [feasibility.sharpest] if feasibility.sharpest else []
    return findings or [Finding("check.clear")]


def rows(results: Results) -> list[Row]:
    """Rows of the table of margins: figure, worst value, its tile, wanted value, number of tiles short."""
    return [row(figure, results["feasibility"].blocked) for figure in results["feasibility"].figures]


def row(figure: TileFigure, blocked: Sequence[Obstacle], number: Callable[[float, str], str] = format) -> Row:
    """number: writes a value of the figure, and how Python does."""
    worst, wanted = figure.worst(), number(figure.needed, "g") + " *" * figure.estimate
    value, tile = ("-", "") if worst is None else (number(figure.values[worst], ".3g"), tile_name(worst))
    return figure.name, value, tile, wanted, str(figure.short(blocked))


def advice(results: Results) -> list[Finding]:
    """Findings on the limits of sizes."""
    get = results.parameters.get
    return list(results["sizes"].findings(get("L"), get("H_body")))


def _reasons(blocked: Sequence[Obstacle]) -> list[str]:
    """The first obstacle of each kind, and how many tiles have one; certain ones before estimates."""
    groups: dict[tuple[bool, str], list[Obstacle]] = {}
    for obstacle in sorted(blocked, key=lambda obstacle: not obstacle.certain):
        groups.setdefault((obstacle.certain, obstacle.obstacle), []).append(obstacle)
    lines = []
    for (certain, _), same in groups.items():
        tiles = len({obstacle.tile for obstacle in same})
        lines.append(f"{tile_name(same[0].tile)}: {same[0].why}" + " *" * (not certain)
                     + f" ({tiles} tiles)" * (tiles > 1))
    return lines


HEAD = ("", "worst", "tile", "wanted", "tiles short")


def table(results: Results) -> list[str]:
    """Lines for a terminal, on margins and what is in the way."""
    feasibility, get = results["feasibility"], results.parameters.get
    lines = [f"{results.name}: {len(feasibility.F)} tiles, L = {get('L'):.4g} mm, "
             f"H_body = {get('H_body'):g} mm"]
    for what, value, tile, wanted, short in (HEAD, *rows(results)):
        lines.append(f"  {what:<42}{value:>9}  {tile:<8}{wanted:>7}  {short:>11}")
    return [*lines, f"  {ESTIMATE}", ", ".join(map(str, verdict(results))),
            *(f"  {line}" for line in _reasons(feasibility.blocked))]


def build_page(results: Results) -> str:
    """Text of check.html."""
    feasibility = results["feasibility"]
    blocked, count = feasibility.blocked, len(feasibility.F)
    marks = np.zeros(count, int)  # 1: likely to fail, 2: can't be made
    for obstacle in sorted(blocked, key=lambda obstacle: obstacle.certain):
        marks[obstacle.tile] = 2 if obstacle.certain else 1
    picture = Picture("", "The target from both sides: tiles that can't be made in red, those that are "
                          "likely to fail in orange.", "pictures.blocked_view",
                      {"V": feasibility.V, "F": feasibility.F, "marks": marks})
    return html.render("check.html", title=results.title, blocked=blocked, tiles=count, picture=picture,
                       lines=[*verdict(results), *advice(results)], rows=rows(results), head=HEAD,
                       estimate=ESTIMATE, most_listed=_MOST_LISTED)
