# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three judgements of every target side by side, with bumps and with dimples: `valid` (least squares and
geometry), `unilateral` (forces that push within friction exist) and `holds` (the forces that develop).
`tools/bench --settled` runs it: each row goes into the table of resources/docs/settled.md as soon as it is
known."""

from __future__ import annotations

import argparse
from typing import Any

from targets import chosen, solved, used

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.stages import asked_by

WORDS = {True: "yes", False: "no", None: "-"}
Row = dict[str, Any]


def judge(target: str, bumps: str) -> Row:
    project = solved(target, bumps=bumps)
    begun = used()
    results = project.run(asked_by("solve", "settle"))
    report = {**results["verification"].report(), **results["settle"].report()}
    return {"tiles": len(results.design.F), "valid": results.verdict.valid, "holds": results.verdict.holds,
            "report": report, "processor": used() - begun}


def cells(row: Row) -> list[str]:
    report, block = row["report"], row["report"].get("settled", {})
    scan = block.get("scan", {})
    return [str(row["tiles"]), WORDS[row["valid"]], WORDS[report.get("unilateral", {}).get("feasible")],
            WORDS[row["holds"]], str(len(block.get("open_contacts", ()))), f"{block.get('drift_mm', 0):.3f}",
            f"{scan.get('mean_mm', 0):.3f} / {scan.get('max_mm', 0):.3f}",
            WORDS[report.get("margin", {}).get("met")], f"{row['processor']:.1f}"]


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --settled", description=__doc__)):
        for bumps in ("bumps", "dimples"):
            try:
                row = {"name": f"{name}, {bumps}", **judge(target, bumps)}
            except CurveUpsError as error:
                print(f"{name}, {bumps}: {error}", flush=True)
                continue
            renew([row], DOCS / "settled.md", {"settled": cells})
            print(f"{row['name']}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
