# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three judgements of every built-in target side by side, with bumps and with dimples: `valid` (least squares
and geometry), `unilateral` (forces that push within friction exist) and `holds` (the forces that develop), as
the table of resources/docs/settled.md.

    python3 tests/benchmarks/settled.py [--only NAME,...] [--models DIR]
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Workbench"))

from curveups.base.errors import CurveUpsError  # noqa: E402
from curveups.base.native import native  # noqa: E402
from curveups.project.project import Project  # noqa: E402
from curveups.stages import asked_by  # noqa: E402
from curveups.stages.cut_request import CutRequest  # noqa: E402
from curveups.stages.surface import find_source  # noqa: E402

HEAD = ("design", "walls", "tiles", "valid", "unilateral", "holds", "open", "drift, mm", "scan, mm",
        "least friction", "margin", "verify, s", "settle, s")
WORDS = {True: "yes", False: "no", None: "-"}


def judge(name: str, target: str, bumps: str) -> list[Any]:
    values = native.Parameters()
    values.set("bumps", bumps)
    source = find_source(target, remesh=name == target, will_be_cut=False)
    project = Project(name, values, {"source": source, "cut request": CutRequest()}, target)
    results = project.run(asked_by("solve", "settle"))
    report = {**results["verification"].report(), **results["settle"].report()}
    block, seconds = report.get("settled", {}), {row.name: row.seconds for row in results.rows()}
    scan, held = block.get("scan", {}), block.get("holding_friction")
    return [name, bumps, len(results.design.F), WORDS[results.verdict.valid],
            WORDS[report.get("unilateral", {}).get("feasible")], WORDS[results.verdict.holds],
            len(block.get("open_contacts", ())), f"{block.get('drift_mm', 0):.3f}",
            f"{scan.get('mean_mm', 0):.3f} / {scan.get('max_mm', 0):.3f}",
            "-" if held is None else f"{held:.2g}", WORDS[report.get("margin", {}).get("met")],
            f"{seconds.get('verify', 0):.1f}", f"{seconds.get('settle', 0):.1f}"]


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", metavar="NAME,...")
    parser.add_argument("--models", type=Path, metavar="DIR", help="meshes to be taken as they are, besides")
    options = parser.parse_args()
    targets = {name: name for name, _ in native.builtin_targets()}
    targets.update({path.stem: str(path) for path in sorted(options.models.glob("*.obj"))}
                   if options.models else {})
    print("| " + " | ".join(HEAD) + " |\n|" + "---|" * len(HEAD))
    for name in options.only.split(",") if options.only else targets:
        for bumps in ("bumps", "dimples"):
            try:
                row = judge(name, targets[name], bumps)
            except CurveUpsError as error:
                row = [name, bumps, str(error)]
            print("| " + " | ".join(map(str, row)) + " |", flush=True)


if __name__ == "__main__":
    main()
