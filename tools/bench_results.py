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
    """Seconds of all runs of stages, with as many digits as mean something."""
    total = sum(stage["seconds"] for stage in row["stages"] if stage["name"] in names)
    ran = any(stage["name"] in names for stage in row["stages"])
    return _number(total if ran else None, 1 if total < 10 else 0)


def _forces(row: Row) -> list[str]:
    """Mean and least normal force, mean relative friction, largest floor over the mean force."""
    forces, unilateral = row.get("contact_forces"), row.get("unilateral")
    if not forces or not unilateral:
        return ["-"] * 3
    mean = forces["normal_mean"]
    return [f"{mean:.2f}, {forces['normal_min']:.2f}", _number(forces["friction_ratio_mean"]),
            _number(unilateral["largest_floor"] / mean)]


TABLES: Tables = {
    "models": lambda row: [
        str(row["tiles"]), _number(row["area"].get("ratio")), *_forces(row),
        _seconds(row, "flatten", "layout"), _seconds(row, "verify"), _seconds(row, "refine"),
        _number(row["seconds_to_valid"], 1), _number(row["paper_seconds"], 0),
        _number(row["seconds_to_holds"], 1), _number(row["seconds_waited"], 1),
        _number(row["peak_memory_mb"], 0)],
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
