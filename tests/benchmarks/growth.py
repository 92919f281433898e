# SPDX-License-Identifier: LGPL-2.1-or-later
"""How seconds and memory grow with the number of tiles, on ever larger half-spheres of tiles of one size.
Called by tools/bench --growth.

    growth.py [--tiles N,...] [--no-files] [--read FILE] [--json FILE] [--plot FILE]

Every size runs in a process of its own, stage by stage. Wall seconds hold on a machine that does nothing
else; processor seconds say what was done where others work, too. --plot draws these, with the exponents
that fit them."""

from __future__ import annotations

import argparse
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable, Iterator

ROOT = Path(__file__).resolve().parents[2]
SIZES = (500, 1000, 2500, 5000, 10_000, 25_000)
TILES_AT_ONE = 691  # of the built-in half-sphere at the default L
# Rows of the table, and the stages whose time they are; files by the ending.
ROWS = {"remesh": ("source", "surface", "target"), "layout": ("layout",),
        "verify": ("verification of the layout", "verification"), "repair": ("repair",),
        "bodies": ("bodies",), "checks": ("solids", "check"),
        "3mf": ("3mf",), "step": ("step",), "stl": ("stl",)}
FILES = {part for row in ("bodies", "checks", "3mf", "step", "stl") for part in ROWS[row]}
TO_VALID, ALL_ELSE = "mesh to valid", "all but the layout"
GOALS = {"layout": 1.4}  # exponents
GOAL = 1.2               # of all others
ENVIRONMENT = {"OPENBLAS_NUM_THREADS": "1", "MMGT_OPT": "2"}  # as the command line has it (cli/__main__.py)


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/bench --growth", description=__doc__.split("\n\n")[0])
    parser.add_argument("--tiles", type=lambda text: [int(n) for n in text.split(",")], default=list(SIZES),
                        metavar="N,...", help=f"about how many (default: {','.join(map(str, SIZES))})")
    parser.add_argument("--no-files", action="store_true", help="end with the verified design")
    parser.add_argument("--read", type=Path, metavar="FILE", action="append", default=[],
                        help="take these figures of --json instead of running")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there")
    parser.add_argument("--plot", type=Path, metavar="FILE", help="draw them there (svg, png)")
    parser.add_argument("--one", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.one:
        print(json.dumps(_measure(options.one, not options.no_files)))
        return 0
    runs = [run for path in options.read for run in json.loads(path.read_text(encoding="utf-8"))]
    for run in runs:
        print(_line(run))
    for tiles in () if options.read else options.tiles:
        more = ["--no-files"] if options.no_files else []
        done = subprocess.run([sys.executable, __file__, "--one", str(tiles), *more], stdout=subprocess.PIPE,
                              text=True, check=True, env={**ENVIRONMENT, **os.environ})
        runs.append(json.loads(done.stdout))
        print(_line(runs[-1]), flush=True)
    for clock in ("wall", "processor"):
        print(f"exponents, {clock}: " + ", ".join(f"{row} {found:.2f} (goal {GOALS.get(row, GOAL)})"
                                                  for row, found in exponents(runs, clock).items()))
    if options.json:
        options.json.write_text(json.dumps(runs, indent=1) + "\n", encoding="utf-8")
    if options.plot:
        draw(runs, options.plot)
    return 0 if all(run["valid"] for run in runs) else 1


def _measure(tiles: int, files: bool) -> dict[str, Any]:
    """Seconds by wall and processor of every stage, and the peak of memory."""
    from curveups.base import machine
    from curveups.base.native import native
    from curveups.project.project import Project
    from curveups.stages import asked_by
    from curveups.stages.cut_request import CutRequest
    from curveups.stages.stage import Job
    from curveups.stages.surface import find_source

    machine.keep_memory()  # as the command line does
    parameters = native.Parameters()
    parameters.set("scale", math.sqrt(tiles / TILES_AT_ONE))
    project = Project("half-sphere", parameters,
                      {"source": find_source("half-sphere"), "cut request": CutRequest()})
    wall: dict[str, float] = {}
    processor: dict[str, float] = {}

    def clocked(name: str, work: Callable[[], Any]) -> Any:
        start, used = time.perf_counter(), _processor()
        made = work()
        wall[name] = wall.get(name, 0.0) + time.perf_counter() - start
        processor[name] = processor.get(name, 0.0) + _processor() - used
        return made

    # Suggested cuts are no part of a design that needs none.
    goals = [name for name in asked_by("solve") if name != "suggestions"]
    job = Job()
    for goal in goals:
        results = clocked(goal, lambda: project.run((goal,), job))
    memory = machine.peak_memory_mb()
    if files:
        for goal in asked_by("print"):
            results = clocked(goal, lambda: project.run((*goals, goal), job))
        with tempfile.TemporaryDirectory(prefix="curveups-growth-") as folder:
            for one in native.print_formats():
                for kind in one.kinds:
                    file = Path(folder, kind)
                    clocked(one.ending,
                            lambda: results["solids"].model.write(one.ending, kind, str(file), job))
                    file.unlink()
    results = project.run(("figures", "verification"), job)
    return {"tiles": results["figures"].tiles, "valid": results["verification"].valid,
            "memory_mb": memory,
            "memory_with_files_mb": machine.peak_memory_mb() if files else None,
            "wall": wall, "processor": processor}


def _processor() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def _rows(run: dict[str, Any], clock: str) -> Iterator[tuple[str, float]]:
    """The table's rows of one run, all from the mesh to the verdict, and all that was run but the layout;
    those of no time to speak of are left out."""
    for row, parts in ROWS.items():
        seconds = sum(run[clock].get(part, 0.0) for part in parts)
        if seconds > 0.02:
            yield row, seconds
    yield TO_VALID, sum(seconds for part, seconds in run[clock].items() if part not in FILES)
    yield ALL_ELSE, sum(seconds for part, seconds in run[clock].items() if part not in ROWS["layout"])


def _line(run: dict[str, Any]) -> str:
    wall, processor = dict(_rows(run, "wall")), dict(_rows(run, "processor"))
    return (f"{run['tiles']:>6} tiles {'valid' if run['valid'] else 'not valid':<9}"
            + "".join(f" {row} {wall[row]:.1f} ({processor.get(row, 0):.1f})" for row in wall)
            + f", {run['memory_mb']:.0f} MB")


def exponents(runs: list[dict[str, Any]], clock: str) -> dict[str, float]:
    """By row, p of seconds ~ tiles^p: least squares of the logarithms."""
    points: dict[str, list[tuple[float, float]]] = {}
    for run in runs:
        for row, seconds in _rows(run, clock):
            points.setdefault(row, []).append((math.log(run["tiles"]), math.log(seconds)))
    found = {}
    for row, at in points.items():
        if len(at) < 3:
            continue
        x, y = (sum(values) / len(at) for values in zip(*at))
        found[row] = (sum((a - x) * (b - y) for a, b in at) / sum((a - x) ** 2 for a, _ in at))
    return found


def draw(runs: list[dict[str, Any]], path: Path) -> None:
    """Processor seconds by tiles, both axes logarithmic, with the exponents."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "curveups"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 5))
    fits = exponents(runs, "processor")
    rows = [row for row in (*ROWS, TO_VALID, ALL_ELSE) if row in fits]
    for row in rows:
        at = [(run["tiles"], dict(_rows(run, "processor")).get(row)) for run in runs]
        axes.loglog(*zip(*[point for point in at if point[1]]), marker="o", markersize=3,
                    linewidth=1 if row in ROWS else 2, label=f"{row}: n^{fits[row]:.2f}")
    axes.set_xlabel("tiles")
    axes.set_ylabel("seconds of one processor")
    axes.grid(True, which="both", linewidth=0.3)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None)


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "Workbench"))
    sys.exit(main())
