# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judgements of every target side by side, with bumps and with dimples: `valid` (least squares and geometry),
`unilateral` (forces that push within friction exist), `holds` (the forces that develop) and `margin`.
`tools/bench --settled` runs it: each row goes into the table of resources/docs/settled.md as soon as it is
known."""

from __future__ import annotations

import argparse
from typing import Any

from targets import chosen, solved, used

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.stages import stages_of

WALLS = ("bumps", "dimples")
Row = dict[str, Any]


def judge(target: str, bumps: str) -> Row:
    """Judgements by name, and figures of the settled state."""
    project = solved(target, bumps=bumps)
    begun = used()
    results = project.run(stages_of("solve", "settle"))
    report = {**results["verification"].report(), **results["settle"].report()}
    block = report.get("settled", {})
    return {"tiles": len(results.design.F), "block": block, "seconds": used() - begun,
            "judgements": {"valid": results.verdict.valid,
                           "unilateral": report.get("unilateral", {}).get("feasible"),
                           "holds": results.verdict.holds, "margin": report.get("margin", {}).get("met")}}


def outcome(row: Row) -> str:
    """Judgements that fail or are not known, then drift, mean and largest distance from the design, mm."""
    failed = [name for name, met in row["judgements"].items() if not met]
    scan = row["block"].get("scan", {})
    return (f"{'not ' + ', '.join(failed) if failed else 'all'}; {row['block'].get('drift_mm', 0):.3f};"
            f" {scan.get('mean_mm', 0):.3f}, {scan.get('max_mm', 0):.3f}")


def cells(row: Row) -> list[str]:
    """Columns of the table after the name. A design that fails has a dash."""
    judged = [row[walls] for walls in WALLS]
    tiles = next((str(one["tiles"]) for one in judged if one), "-")
    return [tiles, *(outcome(one) if one else "-" for one in judged),
            ", ".join(f"{one['seconds']:.1f}" if one else "-" for one in judged)]


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --settled", description=__doc__)):
        row: Row = {"name": name}
        for walls in WALLS:
            try:
                row[walls] = judge(target, walls)
            except CurveUpsError as error:
                row[walls] = None
                print(f"{name}, {walls}: {error}", flush=True)
        renew([row], DOCS / "settled.md", {"settled": cells})
        print(f"{name}: {' | '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
