# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape of the built piece of every target, as it is and with little friction needed. `tools/bench
--actuation` runs it: each row goes into the table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
from time import monotonic
from typing import Any

from targets import chosen, solved

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.stages import RISEN
from curveups.stages.actuation import STATES

Block = dict[str, Any]


def actuate(name: str, target: str, self_shaping: bool) -> Block:
    """Block of report.json, with the friction that the design needs and what the run took, in seconds."""
    begun = monotonic()
    project = solved(target, bumps="bumps", self_shaping=self_shaping)
    design = monotonic()
    report = project.run(("settle", RISEN))
    needed = report["settle"].friction_needed.get("coefficient")
    block = report[RISEN].report()["actuation"]
    return {**block, "name": f"{name}, little friction" if self_shaping else name,
            "friction_needed": needed,
            "tiles": len(project.latest("design").design.F),
            "seconds": (design - begun, monotonic() - design)}


def cells(row: Block) -> list[str]:
    """Columns of the table after the name."""
    def end(state: Block) -> str:
        if not state["converged"]:
            return "no rest"
        return f"{state['mean_mm']:.2f}, {state['max_mm']:.1f}; {len(state['open_contacts'])}"

    needed, spread = row["friction_needed"], row["spread"]["mean_mm"]
    return [str(row["tiles"]), "-" if needed is None else f"{needed:.2f}",
            *(end(row[name]) for name in STATES),
            " to ".join(f"{mean:.2f}" for mean in spread) if spread else "-",
            ", ".join(f"{seconds:.0f}" for seconds in row["seconds"])]


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --actuation", description=__doc__)):
        for self_shaping in (False, True):
            try:
                row = actuate(name, target, self_shaping)
            except CurveUpsError as error:
                print(f"{name}, self_shaping={self_shaping}: {error}", flush=True)
                continue
            renew([row], DOCS / "actuation.md", {"actuation": cells})
            print(f"{row['name']}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
