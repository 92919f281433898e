# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seconds that a user waits, for whole commands and in FreeCAD's window on a virtual display, drawn by
software. Called by tools/bench --wait.

    waits.py [--models DIR] [--against CHECKOUT] [--runs N] [--only commands|window] [--json FILE]

--against: another checkout, built, whose commands run beside those of this one; rows have the ratio then.
Figures of commands are medians of N runs, those of the window of one.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Iterator, Optional

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))

from window import freecad_home, run_in_window  # noqa: E402

VALID = ["--no-solids", "--set", "run_settling=off"]
HOLDS = ["--no-solids"]

# Name, model (a mesh of --models, or a built-in target), options, and those of the other checkout.
COMMANDS = [
    ("to valid, Turtle", "turtle.obj", VALID, HOLDS),
    ("to holds, Turtle", "turtle.obj", HOLDS, None),
    ("to valid, Spot", "spot.obj", VALID, HOLDS),
    ("to holds, Spot", "spot.obj", HOLDS, None),
    ("all files, Half-Sphere", "half-sphere", [], []),
    ("all files, Lilium", "lilium.obj", [], []),
    ("all files, Spot", "spot.obj", [], []),
    ("to valid, 10,145 tiles", "half-sphere", ["--set", "scale=3.82", *VALID],
     ["--set", "scale=3.82", *HOLDS]),
]

# Waits are over when the last event of the window's loop is handled. A pause is the longest time in which a
# timer of 5 ms did not come.
WORK = """
import json, time
import numpy as np
from curveups.features.design import project_of
from curveups.features.document import new_design
from curveups.features.parts import write_cuts
from curveups.window import run as runs
from curveups.window.cuts import CutLayout
from curveups.window.run import LIVE

figures, pauses, last = {}, {}, time.perf_counter()
step = 'start'

def beat():
    global last
    now = time.perf_counter()
    pauses[step] = max(pauses.get(step, 0), now - last)
    last = now

def wait(name, done, most=300):
    start = time.perf_counter()
    while not done():
        QtGui.QApplication.processEvents()
        time.sleep(0.002)
        if time.perf_counter() - start > most:
            raise RuntimeError(name + ' takes too long')
    QtGui.QApplication.processEvents()

def timed(name, work, done):
    global step
    step = name
    start = time.perf_counter()
    work()
    wait(name, done)
    figures[name] = time.perf_counter() - start

def idle():
    return not LIVE.busy

def judged(design):
    return idle() and design.Verdict == 'valid'

def whole(design):
    # Verdict and solids are those of the properties. Their comparison itself would take time here.
    return judged(design) and all(part.Status == 'current'
                                  for part in (design.Tiles, design.Support, design.Anchors))

def edit(design, name, value):
    document = design.Document
    document.openTransaction('Edit ' + name)
    setattr(design, name, value)
    document.recompute()
    document.commitTransaction()

def cut_of(design):
    # A path of six edges from the border towards the middle, and the vertices' coordinates.
    target = project_of(design).latest('target')
    V, F = np.asarray(target.V), np.asarray(target.F)
    pairs = np.sort(np.concatenate([F[:, [0, 1]], F[:, [1, 2]], F[:, [2, 0]]]), axis=1)
    pairs, count = np.unique(pairs, axis=0, return_counts=True)
    far = np.linalg.norm(V - V.mean(0), axis=1)
    vertex = int(pairs[count == 1][0, 0])
    path = []
    for _ in range(6):
        beside = [int(b if a == vertex else a) for a, b in pairs if vertex in (a, b)]
        nearest = min(beside, key=lambda v: far[v])
        path.append((vertex, nearest))
        vertex = nearest
    return np.array(path), V

def edit_and(run_name, design, name, value):
    edit(design, name, value)
    runs.start(run_name, design)

def work():
    timer = QtCore.QTimer()
    timer.timeout.connect(beat)
    timer.start(5)
    FreeCADGui.getMainWindow().resize(1440, 900)
    FreeCADGui.activateWorkbench('CurveUpsWorkbench')
    settle(500)
    for scale, tiles in (0.95, 'small'), (1.9, 'large'):
        document = FreeCAD.newDocument('Design')
        design = new_design(document, 'half-sphere')
        design.Scale = scale
        document.recompute()
        settle(300)
        timed(f'solve, {tiles}', lambda: runs.start('solve', design), lambda: judged(design))
        figures[f'tiles, {tiles}'] = design.TileCount
        timed(f'solids, {tiles}', lambda: runs.start('build_solids', design), lambda: whole(design))
        timed(f'HBody, {tiles}', lambda: edit_and('verify', design, 'HBody', design.HBody.Value + 0.2),
              lambda: whole(design))
        timed(f'HPin, {tiles}', lambda: edit_and('verify', design, 'HPin', design.HPin.Value + 0.2),
              lambda: whole(design))
        if tiles == 'small':
            timed(f'Tau, {tiles}', lambda: edit_and('solve', design, 'Tau', design.Tau * 0.99),
                  lambda: judged(design))
            timed(f'L, {tiles}', lambda: edit_and('solve', design, 'L', design.L.Value * 0.98),
                  lambda: judged(design))
            FreeCAD.closeDocument(document.Name)
            continue
        edges, V = cut_of(design)
        layout = CutLayout(design, project_of(design))
        timed('a cut: layout', lambda: layout.start(edges, lambda: None), idle)
        document.openTransaction('Cut')
        write_cuts(design.Cuts, edges, V)
        document.commitTransaction()
        timed('a cut: verified', lambda: runs.start('solve', design), lambda: judged(design))
        timed('undo', document.undo, idle)
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        timed('open', lambda: FreeCAD.openDocument(path), lambda: FreeCAD.ActiveDocument is not None)
    timer.stop()
    with open(output, 'w') as file:
        json.dump({'figures': figures, 'pauses': pauses}, file)
"""


def seconds_of(python: str, checkout: Path, arguments: list[str]) -> tuple[float, dict]:
    """Seconds of a whole command, and its report."""
    with tempfile.TemporaryDirectory(prefix="curveups-wait-") as folder:
        begun = time.perf_counter()
        done = subprocess.run([python, "-m", "curveups.cli", "design", *arguments, "-o", folder, "--quiet"],
                              env={**os.environ, "PYTHONPATH": str(checkout / "Workbench")},
                              capture_output=True, text=True)
        waited = time.perf_counter() - begun
        report = Path(folder, "report.json")
        if not report.exists():
            raise SystemExit(f"{' '.join(arguments)}: {done.stderr.strip()}")
        return waited, json.loads(report.read_text("utf-8"))


def commands(models: Optional[Path], against: Optional[Path], runs: int) -> Iterator[tuple]:
    """Name, median seconds, ratio to the other checkout, peak memory in MB, verdict."""
    for name, model, options, others_options in COMMANDS:
        mesh = model.endswith(".obj")
        if mesh and models is None:
            continue
        target = [str(models / model), "--no-remesh"] if mesh else [model]
        waited, others, report = [], [], {}
        for _ in range(runs):
            seconds, report = seconds_of(sys.executable, ROOT, [*target, *options])
            waited.append(seconds)
            if against and others_options is not None:
                others.append(seconds_of(sys.executable, against, [*target, *others_options])[0])
        median = statistics.median(waited)
        yield (name, median, median / statistics.median(others) if others else None,
               report["peak_memory_mb"], report["valid"])


def in_window() -> dict:
    """Seconds and longest pauses in FreeCAD's window, by name."""
    with tempfile.TemporaryDirectory() as place:
        home, output = freecad_home(Path(place) / "home", True), Path(place) / "figures.json"
        run_in_window(WORK, home, place, timeout=900, path=Path(place) / "large.FCStd", output=output)
        return json.loads(output.read_text("utf-8"))


def main() -> int:
    parser = argparse.ArgumentParser(prog="tools/bench --wait", description="Seconds that a user waits.")
    parser.add_argument("--models", type=Path, metavar="DIR", help="a folder with target meshes")
    parser.add_argument("--against", type=Path, metavar="CHECKOUT", help="another checkout, built")
    parser.add_argument("--runs", type=int, default=5, metavar="N", help="of each command (default: 5)")
    parser.add_argument("--only", choices=("commands", "window"))
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there too")
    options = parser.parse_args()
    rows = []
    if options.only != "window":
        for row in commands(options.models, options.against, options.runs):
            name, seconds, ratio, memory, valid = row
            rows.append(dict(zip(("name", "seconds", "ratio", "memory_mb", "valid"), row)))
            beside = "" if ratio is None else f"{ratio:8.2f} of the other"
            print(f"{name:32}{seconds:8.1f} s{memory:7.0f} MB  {'valid' if valid else 'not valid'}{beside}",
                  flush=True)
    if options.only != "commands":
        window = in_window()
        for name, value in window["figures"].items():
            pause = window["pauses"].get(name)
            rows.append({"name": name, "seconds": value, "pause": pause})
            unit = "" if name.startswith("tiles") else " s"
            shown = "" if pause is None else f"   longest pause {pause:.2f} s"
            print(f"window, {name:24}{value:8.1f}{unit}{shown}")
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
