# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `curveups check` says beside what `curveups design` then finds: counted over the thirty targets, the
built-in ones and meshes of a folder, each with ten settings of parameters.

    python tests/benchmarks/check_agrees.py FOLDER [--models DIR] [--only NAME,...]

FOLDER gets the targets, and verdicts.jsonl with a line for each pair that is done: run again, it goes on
where it ended. Tiles are 10 mm long instead of 7, in the same proportions, so that there are half as many.
Neither looks for other sizes, and no solids are built. What takes longer than LONGEST seconds
of processor time has no verdict and is not counted. Prints the table of what there is so far (--table: only
that)."""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any, Mapping, Optional

import thirty_targets as thirty
from curveups.base.errors import CurveUpsError, Stopped
from curveups.base.native import native
from curveups.project.project import Project
from curveups.stages.cut_request import CutRequest
from curveups.stages.stage import Job
from curveups.stages.surface import find_source

BASE = {"L": 10.0, "H_body": 4.3, "H_pin": 1.4, "mend": "on"}
SETTINGS: dict[str, dict[str, Any]] = {
    "base": {}, "mend=off": {"mend": "off"}, "H_body=7": {"H_body": 7.0}, "H_pin=0.8": {"H_pin": 0.8},
    "L=13": {"L": 13.0}, "H_body=2": {"H_body": 2.0}, "H_pin=2.8": {"H_pin": 2.8}, "tau=2": {"tau": 2.0},
    "tau=4.5": {"tau": 4.5}, "L=8": {"L": 8.0},
}
LONGEST = 120.0  # seconds of processor time


def made(target: str, cuts: int, setting: Mapping[str, Any], job: Job) -> Project:
    """A project that has nothing but its target, its parameters and its cuts."""
    parameters = native.Parameters()
    for name, value in {**BASE, **setting}.items():
        parameters.set(name, value)
    request = CutRequest(suggested=cuts)
    given = {"source": find_source(target, will_be_cut=cuts > 0), "cut request": request}
    project = Project(Path(target).stem, parameters, given, Path(target).name)
    if cuts:
        project.give("cut request", request.accept(project.run(("cut search",), job)["cut search"]))
    return project


def designed(project: Project, job: Job) -> dict[str, Any]:
    """The verdict of design; why not, and of which kinds the reasons are."""
    results = project.run(("figures", "verification", "recheck", "clearances"), job)
    reasons = results.verdict.reasons
    return {"design": results.verdict.valid, "why": "; ".join(map(str, reasons[:1])),
            "reasons": sorted({one.kind for one in reasons})}


def job_of(begun: float) -> Job:
    """Stops what takes longer than LONGEST."""
    return Job(lambda what, fraction: time.process_time() - begun < LONGEST)


def judge(target: str, cuts: int, setting: Mapping[str, Any]) -> dict[str, Any]:
    """Verdicts of check and design: yes, no, or None where it took too long; why not, and of which kinds the
    design's reasons are."""
    begun = time.process_time()
    job = job_of(begun)
    said: dict[str, Any] = {"check": False, "design": False, "tiles": None, "obstacles": [], "why": "",
                            "reasons": [], "check_seconds": None}
    try:
        project = made(target, cuts, setting, job)
        checked = project.run(("trial layout",), job)
        found = checked["trial layout"]
        said.update(check=found.feasible, tiles=len(checked["feasibility"].F),
                    obstacles=sorted({one.obstacle for one in found.blocked}),
                    check_seconds=round(time.process_time() - begun, 1))
        said.update(designed(project, job))
    except CurveUpsError as error:  # refused, by both where check is
        said.update(why=error.what, reasons=["refused"])
    except Stopped:
        pass
    if job.stopped:
        said["design"] = None
    return {**said, "seconds": round(time.process_time() - begun, 1)}


def table(rows: list[dict[str, Any]]) -> list[str]:
    lines = ["| setting | targets | yes, valid | no, not valid | yes, not valid | no, valid | right |",
             "|---|---|---|---|---|---|---|"]
    for setting in (*SETTINGS, None):
        of = [row for row in rows if setting in (None, row["setting"]) and row["design"] is not None]
        count = Counter((bool(row["check"]), bool(row["design"])) for row in of)
        cells = [count[pair] for pair in ((True, True), (False, False), (True, False), (False, True))]
        if of:
            lines.append(f"| {setting or 'all'} | {len(of)} | " + " | ".join(map(str, cells))
                         + f" | {100 * (cells[0] + cells[1]) / len(of):.0f} % |")
    return lines


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--models", type=Path)
    arguments.add_argument("--only", type=lambda text: set(text.split(",")))
    arguments.add_argument("--table", action="store_true")
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    file = options.folder / "verdicts.jsonl"
    rows = [json.loads(line) for line in file.read_text("utf-8").splitlines()] if file.exists() else []
    if not options.table:
        done = {(row["target"], row["setting"]) for row in rows}
        with file.open("a", encoding="utf-8") as out:
            for name, path, setting in _all(options.folder, options.models, options.only):
                if (name, setting) in done:
                    continue
                rows.append({"target": name, "setting": setting,
                             **judge(path, thirty.CUT.get(name, 0), SETTINGS[setting])})
                print(json.dumps(rows[-1]), file=out, flush=True)
    print(*table(rows), sep="\n")


def _all(folder: Path, models: Optional[Path], only: Optional[set[str]]) -> Any:
    """Names, targets and settings: every target with one setting, then with the next."""
    targets = {name: str(path) for name, path in thirty.targets(folder, only).items()}
    targets.update({name: name for name, _ in native.builtin_targets()})
    if models:
        targets.update({path.stem: str(path) for path in sorted(models.glob("*.obj"))})
    for setting in SETTINGS:
        for name, target in targets.items():
            if only is None or name in only:
                yield name, target, setting


if __name__ == "__main__":
    sys.exit(main())
