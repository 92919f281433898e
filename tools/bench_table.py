# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs `curveups design` on every model, each in a process of its own (so that the peak memory is
the model's), and prints the stages beside the paper's seconds. Called by tools/bench.

Status 1 where a file is wrong, or a built-in target or a model of the paper is not valid."""

from __future__ import annotations

import argparse
import json
import multiprocessing
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bench_results import RESULTS, renew
from read_back import read_back

MESHES = (".obj", ".stl", ".ply", ".off")
STAGES = ("remesh", "pin smoothing", "flatten", "layout", "verify", "refine", "settle", "solids", "check",
          "export")

# Table 1: tiles and the seconds of soft and hard optimisation, global check and local refinement.
# "spherical" and "spot" are other versions of the paper's meshes.
PAPER = {
    "half-sphere": (594, 40 + 31 + 59), "spherical": (594, 40 + 31 + 59),
    "hyperboloid": (571, 51 + 27 + 33), "lilium": (1844, 318 + 286 + 173),
    "turtle": (2212, 665 + 426 + 1162 + 1096), "spot": (2545, 1936 + 557 + 1362 + 6205),
}
SETTINGS = {
    "half-sphere": ["--set", "L=7.5"],  # the paper's 594 tiles
    # How time and memory grow with the number of tiles, up to the verdict.
    "half-sphere-10000": ["--set", "scale=3.82", "--no-solids"],
}
TARGETS = {"half-sphere-10000": "half-sphere"}  # where a model's name is no built-in target's


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/bench", description="Table 1, side by side.")
    parser.add_argument("--models", type=Path, metavar="DIR", help="a folder with target meshes")
    parser.add_argument("--only", metavar="NAME,...", help="only these models")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there")
    parser.add_argument("--results", action="store_true", help=f"renew the tables of {RESULTS.name}")
    options = parser.parse_args()
    if options.models and not options.models.is_dir():
        parser.error(f"{options.models} is no folder")
    models = _models(options.models)
    if options.only:
        wanted = options.only.split(",")
        unknown = [name for name in wanted if name not in models]
        if unknown:
            parser.error(f"unknown model {unknown[0]}: there are {', '.join(models)}")
        models = {name: models[name] for name in wanted}
    print(f"{'model':<16}{'tiles':>6} " + "".join(f"{stage:>9}" for stage in STAGES)
          + f"{'to valid':>10}{'to holds':>10}{'waited':>8}{'files':>8}{'MB':>7}{'paper s':>9}  valid, holds")
    rows = []
    for name, target in models.items():
        row = _run(name, target)
        rows.append(row)
        print(_line(row), flush=True)
    if options.json:
        options.json.write_text(json.dumps(rows, indent=2) + "\n", encoding="utf-8")
    if options.results:
        renew(rows)
    return 1 if any(_failed(row) for row in rows) else 0


def _failed(row: dict) -> bool:
    if "error" in row or row["wrong_files"]:
        return True
    return row["valid"] is not True and (row["name"] in PAPER or row["name"] in _builtins())


def _builtins() -> dict[str, str]:
    from curveups.base.native import native

    return {name: name for name, _ in native.builtin_targets()} | TARGETS


def _models(folder: Path | None) -> dict[str, str]:
    models = _builtins()
    for path in sorted(folder.iterdir()) if folder else []:
        if path.name.lower().endswith(MESHES):
            models[path.stem] = str(path)
    return models


def _run(name: str, target: str) -> dict:
    """Model of the benchmark; its target is a path where a mesh is taken as it is."""
    extra = ["--no-remesh"] if target.lower().endswith(MESHES) else SETTINGS.get(name, [])
    row = {"name": name, "paper_seconds": PAPER[name][1] if name in PAPER else None}
    with tempfile.TemporaryDirectory(prefix="curveups-bench-") as folder:
        begun = time.perf_counter()
        done = subprocess.run([sys.executable, "-m", "curveups.cli", "design", target, "-o", folder,
                               "--quiet", *extra], capture_output=True, text=True)
        waited = time.perf_counter() - begun
        report = Path(folder, "report.json")
        if not report.exists():
            return {**row, "error": done.stderr.strip() or f"exit status {done.returncode}"}
        found = json.loads(report.read_text(encoding="utf-8"))
        wrong = []
        if "print" in found:
            # In a process of its own: what a parent has used counts as its children's peak memory.
            with multiprocessing.Pool(1) as reader:
                wrong = reader.apply(read_back, (Path(folder), found))
    seconds = {stage["name"]: stage["seconds"] for stage in found["stages"]}
    figures = {name: found.get(name, {}) for name in ("area", "physics", "contact_forces", "unilateral",
                                                      "repair")}
    design = [s for s in ("remesh", "pin smoothing", "flatten", "layout", "verify", "refine") if s in seconds]
    return {
        **row, "tiles": found["tiles"], "valid": found["valid"], "holds": found["holds"],
        "stages": found["stages"], "wrong_files": wrong, **figures,
        "seconds_to_valid": (round(sum(seconds[s] for s in design), 3)
                             if found["valid"] else None),
        "seconds_to_holds": (round(sum(seconds[s] for s in (*design, "settle")), 3)
                             if found["holds"] else None),
        "seconds_waited": round(waited, 3), "seconds_files": seconds.get("export"),
        "peak_memory_mb": found["peak_memory_mb"],
    }


def _line(row: dict) -> str:
    if "error" in row:
        return f"{row['name']:<16}{row['error']}"
    total: dict[str, float] = {}
    for stage in row["stages"]:
        total[stage["name"]] = total.get(stage["name"], 0.0) + stage["seconds"]

    def number(value: float | None, width: int, digits: int = 2) -> str:
        return f"{'-':>{width}}" if value is None else f"{value:>{width}.{digits}f}"

    word = ", ".join({True: "yes", False: "no", None: "not known"}[row[name]] for name in ("valid", "holds"))
    return (f"{row['name']:<16}{row['tiles']:>6} "
            + "".join(number(total.get(stage), 9) for stage in STAGES)
            + number(row["seconds_to_valid"], 10) + number(row["seconds_to_holds"], 10)
            + number(row["seconds_waited"], 8) + number(row["seconds_files"], 8)
            + number(row["peak_memory_mb"], 7, 0)
            + number(row["paper_seconds"], 9, 0)
            + "; ".join([f"  {word}", *row["wrong_files"]]))


if __name__ == "__main__":
    sys.exit(main())
