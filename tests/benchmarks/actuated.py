# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shape of the built piece of every target, as it is laid out and with little friction needed. `tools/bench
--actuation` runs it: each row goes into the table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
from time import monotonic
from typing import Any, Callable

from targets import chosen, solved

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.stages import RISEN
from curveups.stages.actuation import STATES

Block = dict[str, Any]


def actuate(target: str, self_shaping: bool) -> Block:
    """Block of report.json, with the number of tiles, the friction that the design needs and what design and
    answer took, in seconds."""
    begun = monotonic()
    project = solved(target, bumps="bumps", self_shaping=self_shaping)
    report = project.run(("settle", RISEN))
    return {**report[RISEN].report()["actuation"], "tiles": len(project.latest("design").design.F),
            "friction_needed": report["settle"].friction_needed.get("coefficient"),
            "seconds": monotonic() - begun}


def cells(row: Block) -> list[str]:
    """Columns of the table after the name, each figure for the two designs of a target. A design that fails
    has a dash."""
    blocks = [row["as laid out"], row["little friction"]]

    def needed(block: Block) -> str:
        return "-" if block["friction_needed"] is None else f"{block['friction_needed']:.2f}"

    def mean_of(state: str) -> Callable[[Block], str]:
        return lambda block: f"{block[state]['mean_mm']:.2f}" if block[state]["converged"] else "no rest"

    columns = (needed, *map(mean_of, STATES), lambda block: f"{block['seconds']:.0f}")
    return [next((str(block["tiles"]) for block in blocks if block), "-"),
            *(", ".join(text(block) if block else "-" for block in blocks) for text in columns)]


def main() -> None:
    for name, target in chosen(argparse.ArgumentParser(prog="tools/bench --actuation", description=__doc__)):
        row: Block = {"name": name}
        for kind, self_shaping in (("as laid out", False), ("little friction", True)):
            try:
                row[kind] = actuate(target, self_shaping)
            except CurveUpsError as error:
                row[kind] = None
                print(f"{name}, {kind}: {error}", flush=True)
        renew([row], DOCS / "actuation.md", {"actuation": cells})
        print(f"{name}: {' | '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
