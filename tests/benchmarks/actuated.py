# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path from flat of every target, without bumps and with them. `tools/bench --actuation` runs it: each
row goes into the table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
from typing import Any

from targets import chosen, solved, used

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError

BUMPS = {"none": "no bumps", "bumps": "bumps"}  # dimples move as plain walls do
# mm, mean and largest: how far the paper's scans (section 7) are from their targets.
PAPER_SCANS = {"lilium": "below 1, 8", "spot": "below 4.3, 12.8"}
WORDS = {True: "yes", False: "no", None: "no answer"}
Block = dict[str, Any]


def rise(name: str, target: str, bumps: str) -> Block:
    """The block of report.json, with what it took."""
    project = solved(target, bumps=bumps)
    tiles, begun = len(project.latest("design").design.F), used()
    block = project.run(("actuation",))["actuation"].report()["actuation"]
    return {**block, "name": f"{name}, {BUMPS[bumps]}", "tiles": tiles, "processor": used() - begun}


def cells(row: Block) -> list[str]:
    def end(one: Block) -> str:
        return f"{one['shortfall_mm']:.1f}, {len(one['open_contacts'])}" if one["converged"] else "no answer"

    loose = next((one for one in row.get("sampled", ()) if one["friction_coefficient"] == 0), None)
    target = row.get("frictionless_from_target")
    energies = [f"{one['energy_n_mm']:.0f}" if one and one["converged"] else "-" for one in (loose, target)]
    return [str(row["tiles"]), WORDS[row["arrives"]],
            f"{end(row)} of {row['contacts']}" if row["converged"] else end(row),
            f"{row['steps']}, {row['factorizations']}",
            _reach(row),
            end(loose) if loose else "-", " / ".join(energies), WORDS[row.get("trap")],
            f"{row['from_target']['scan']['mean_mm']:.2f}", f"{row['processor']:.0f}"]


def scan_cells(row: Block) -> list[str]:
    def off(one: Block) -> str:
        scan = one["scan"]
        return f"{scan['mean_mm']:.2f}, {scan['max_mm']:.1f}" if one["converged"] else "no answer"

    return [row["paper"], off(row["from_target"]), off(row)]


def _reach(row: Block) -> str:
    if row.get("reach_friction") is not None:
        return f"{row['reach_friction']:.2g}"
    sampled = row.get("sampled", ())
    return ("none" if sampled and all(one["converged"] for one in sampled) else "no answer") + (
        f" of {len(sampled)}" if sampled else "")


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --actuation", description=__doc__)):
        for bumps in BUMPS:
            try:
                row = rise(name, target, bumps)
            except CurveUpsError as error:
                print(f"{name}, {bumps}: {error}", flush=True)
                continue
            row["paper"] = PAPER_SCANS.get(name)
            tables = {"actuation": cells, **({"scans": scan_cells} if row["paper"] else {})}
            renew([row], DOCS / "actuation.md", tables)
            print(f"{row['name']}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
