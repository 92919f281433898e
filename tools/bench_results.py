# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of resources/docs that `tools/bench` renews, row by row.

A table stands between <!-- bench NAME --> and <!-- end -->, one line a model. Models that were measured
replace their line or come last; all others keep theirs."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Callable

DOCS = Path(__file__).resolve().parents[1] / "resources" / "docs"
RESULTS = DOCS / "results.md"
Row = dict[str, Any]
Tables = dict[str, Callable[[Row], list[str]]]


def _number(value: float | None, digits: int = 2) -> str:
    return "-" if value is None else f"{value:.{digits}f}"


def _seconds(row: Row, *names: str) -> str:
    """Seconds of stages, all their runs together; as many digits as mean something."""
    total = sum(stage["seconds"] for stage in row["stages"] if stage["name"] in names)
    ran = any(stage["name"] in names for stage in row["stages"])
    return _number(total if ran else None, 1 if total < 10 else 0)


def _repair(row: Row) -> str:
    repair = row.get("repair")
    if not repair:
        return "-"
    steps = repair["steps"]
    return (f"{steps[0]['weak_points']} weak points, {len(steps) - 1} steps, poses and pins by"
            f" {repair['largest_move_mm']:.2f} mm, vertices by {repair['largest_vertex_move_mm']:.2f} mm")


def _forces(row: Row) -> list[str]:
    physics, forces, unilateral = (row.get(name, {}) for name in ("physics", "contact_forces", "unilateral"))
    if not forces:
        return ["-"] * 5
    mean = forces["normal_mean"]
    return [f"{physics['triangles']:,}", " + ".join(map(str, physics["newton_iterations_fine"])),
            f"{mean:.2f} / {forces['normal_min']:.2f}", _number(forces["friction_ratio_mean"]),
            _number(unilateral["largest_floor"] / mean)]


TABLES: Tables = {
    "seconds": lambda row: [
        str(row["tiles"]), _seconds(row, "remesh"), _seconds(row, "flatten", "layout"),
        _seconds(row, "verify"), _seconds(row, "refine"),
        _number(row["seconds_to_valid"], 1), _number(row["paper_seconds"], 0),
        _number(row["seconds_to_holds"], 1), _seconds(row, "solids", "check"),
        _number(row["seconds_files"], 1), _number(row["seconds_waited"], 1),
        _number(row["peak_memory_mb"], 0)],
    "forces": lambda row: [
        str(row["tiles"]), _number(row["area"].get("ratio")), *_forces(row),
        {True: "yes", False: "no", None: "not judged"}[row["valid"]], _repair(row)],
}


def renew(rows: list[Row], page: Path = RESULTS, tables: Tables = TABLES) -> None:
    """Puts the measured models into the page's tables."""
    text = page.read_text(encoding="utf-8")
    for name, cells in tables.items():
        found = re.search(rf"<!-- bench {name} -->\n(.*?)<!-- end -->", text, re.S)
        if not found:
            raise ValueError(f"{page} has no table {name}")
        head, line, *old = found[1].splitlines()
        lines = {row.split("|")[1].strip(): row for row in old}
        for row in rows:
            if "error" not in row:
                lines[row["name"]] = f"| {' | '.join([row['name'], *cells(row)])} |"
        table = "\n".join([head, line, *lines.values(), ""])
        text = text[:found.start(1)] + table + text[found.end(1):]
    page.write_text(text, encoding="utf-8")
