# SPDX-License-Identifier: LGPL-2.1-or-later
"""The built shape of every target, without bumps and with them. `tools/bench --actuation` runs it: each row
goes into the table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
from typing import Any

from targets import chosen, solved, used

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.stages import RISEN
from curveups.stages.actuation import STATES

BUMPS = {"none": "no bumps", "bumps": "bumps"}  # dimples move as plain walls do
Block = dict[str, Any]


def rise(name: str, target: str, bumps: str) -> Block:
    """The block of report.json, with what it took."""
    project = solved(target, bumps=bumps)
    tiles, begun = len(project.latest("design").design.F), used()
    block = project.run((RISEN,))[RISEN].report()["actuation"]
    return {**block, "name": f"{name}, {BUMPS[bumps]}", "tiles": tiles, "processor": used() - begun}


def cells(row: Block) -> list[str]:
    """Columns of the table after the name."""
    def end(state: Block) -> str:
        if not state["converged"]:
            return "no rest"
        return f"{state['mean_mm']:.2f}, {state['max_mm']:.1f}; {len(state['open_contacts'])}"

    return [str(row["tiles"]), str(row["contacts"]), *(end(row[name]) for name in STATES),
            f"{row['processor']:.0f}"]


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --actuation", description=__doc__)):
        for bumps in BUMPS:
            try:
                row = rise(name, target, bumps)
            except CurveUpsError as error:
                print(f"{name}, {bumps}: {error}", flush=True)
                continue
            renew([row], DOCS / "actuation.md", {"actuation": cells})
            print(f"{row['name']}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
