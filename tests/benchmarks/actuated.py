# SPDX-License-Identifier: LGPL-2.1-or-later
"""The path from flat of every target, without bumps and with them. `tools/bench --actuation` runs it: each
row goes into the table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
import resource
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Workbench"), str(ROOT / "tools")]

from bench_results import DOCS, renew  # noqa: E402
from curveups.base.errors import CurveUpsError  # noqa: E402
from curveups.base.native import native  # noqa: E402
from curveups.project.project import Project  # noqa: E402
from curveups.stages import asked_by  # noqa: E402
from curveups.stages.cut_request import CutRequest  # noqa: E402
from curveups.stages.surface import find_source  # noqa: E402

BUMPS = {"none": "no bumps", "bumps": "bumps"}  # dimples move as plain walls do
WORDS = {True: "yes", False: "no", None: "no answer"}
Block = dict[str, Any]


def used() -> float:
    """Seconds of processor of this process and all its threads."""
    now = resource.getrusage(resource.RUSAGE_SELF)
    return now.ru_utime + now.ru_stime


def rise(name: str, target: str, bumps: str) -> Block:
    """The block of report.json, with what it took."""
    values = native.Parameters()
    values.set("bumps", bumps)
    source = find_source(target, remesh=name == target, will_be_cut=False)
    project = Project(name, values, {"source": source, "cut request": CutRequest()}, target)
    tiles = len(project.run(asked_by("solve")).design.F)
    begun = used()
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
            "none" if row.get("reach_friction") is None else f"{row['reach_friction']:.2g}",
            end(loose) if loose else "-", " / ".join(energies), WORDS[row.get("trap")],
            f"{row['from_target']['scan']['mean_mm']:.2f}", f"{row['processor']:.0f}"]


def main() -> None:
    parser = argparse.ArgumentParser(prog="tools/bench --actuation", description=__doc__)
    parser.add_argument("--only", metavar="NAME,...")
    parser.add_argument("--models", type=Path, metavar="DIR", help="meshes to be taken as they are, besides")
    options = parser.parse_args()
    targets = {name: name for name, _ in native.builtin_targets()}
    if options.models:
        targets |= {path.stem: str(path) for path in sorted(options.models.glob("*.obj"))}
    chosen = options.only.split(",") if options.only else list(targets)
    if unknown := [name for name in chosen if name not in targets]:
        parser.error(f"unknown model {unknown[0]}: there are {', '.join(targets)}")
    for name in chosen:
        for bumps in BUMPS:
            try:
                row = rise(name, targets[name], bumps)
            except CurveUpsError as error:
                print(f"{name}, {bumps}: {error}", flush=True)
                continue
            renew([row], DOCS / "actuation.md", {"actuation": cells})
            print(f"{row['name']}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
