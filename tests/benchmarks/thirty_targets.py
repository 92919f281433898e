# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thirty targets as engineers have them, from one command each: a line of a table per target.

    python tests/benchmarks/thirty_targets.py FOLDER [--only NAME,...]

FOLDER gets the targets and what was made of them. Each is examined as `curveups check` does (without its
search for other sizes, with the cuts of its design) and designed with `mend=on`; where that does not end
valid, once more with the sizes that the design says it is valid with. Columns: verdict of check without and
with mending, tiles, verdict of design, and with its advice followed, largest movement of a vertex (mm),
Hausdorff distance from what was given (mm), seconds of the first design, and its first reason where it is
not valid."""

from __future__ import annotations

import argparse
import json
import math
import re
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Workbench"), str(ROOT / "tests" / "support")]

import cad  # noqa: E402
import shapes  # noqa: E402
from curveups.base.errors import CurveUpsError  # noqa: E402
from curveups.base.native import native  # noqa: E402
from curveups.project.project import Project  # noqa: E402
from curveups.stages.cut_request import CutRequest  # noqa: E402
from curveups.stages.surface import find_source  # noqa: E402
from running import command, environment  # noqa: E402

Surface = tuple[np.ndarray, np.ndarray]
LONGEST = 400  # seconds a design may take
ADVICE = re.compile(r"suggested: ((?:\w+=\S+ ?)+), with which it is valid")  # of stages/parameter_search.py
# Of stages/sizes.py, the last that it names.
ADVICE_OF_ERRORS = re.compile(r".* sizes that were tried, (?:\S+ or )*(\S+=\S+)(?: with (\S+))? does")


def grid(place: Callable[[np.ndarray, np.ndarray], Any], columns: int, rows: int) -> Surface:
    """place(u, v) on the unit square, counter-clockwise."""
    u, v = np.meshgrid(np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    V = np.stack(np.broadcast_arrays(*place(u, v)), axis=-1).reshape(-1, 3).astype(float)
    a = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    b, c, d = a + 1, a + columns + 2, a + columns + 1
    return V, np.vstack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def sheet(height: Callable[[np.ndarray, np.ndarray], Any], size: float = 40.0, parts: int = 60) -> Surface:
    def place(u: np.ndarray, v: np.ndarray) -> Any:
        x, y = size * (2 * u - 1), size * (2 * v - 1)
        return x, y, height(x, y) + 0 * x

    return grid(place, parts, parts)


def with_holes(surface: Surface, holes: list[tuple[float, float, float]]) -> Surface:
    """Without the faces whose centres lie within these circles (x, y, radius)."""
    V, F = surface
    centre = V[F].mean(1)
    gone = np.zeros(len(F), bool)
    for x, y, radius in holes:
        gone |= np.hypot(centre[:, 0] - x, centre[:, 1] - y) < radius
    used, number = np.unique(F[~gone], return_inverse=True)
    return V[used], number.reshape(-1, 3)


def noisy(surface: Surface, size: float) -> Surface:
    return surface[0] + np.random.default_rng(4).normal(0, size, surface[0].shape), surface[1]


def decimated(surface: Surface) -> Surface:
    """Every third row and column of faces merged at random: facets of very different sizes."""
    V, F = surface
    merged = np.arange(len(V))
    pick = np.random.default_rng(5).random(len(F)) < 0.12
    for a, b, _ in F[pick]:
        if merged[a] == a and merged[b] == b:
            merged[b] = a
    F = merged[F]
    return V, F[(F[:, 0] != F[:, 1]) & (F[:, 1] != F[:, 2]) & (F[:, 2] != F[:, 0])]


def together(*parts: Surface) -> Surface:
    V = np.vstack([part[0] for part in parts])
    first = np.cumsum([0] + [len(part[0]) for part in parts])
    return V, np.vstack([part[1] + at for part, at in zip(parts, first)])


def bowl(x: np.ndarray, y: np.ndarray) -> Any:
    return 0.006 * (x * x + y * y)


def zigzag(depth: float, width: float) -> Callable[[np.ndarray, np.ndarray], Any]:
    return lambda x, y: depth * np.abs((x / width) % 2 - 1)


def helix(radius: float, width: float, rise: float, turns: float) -> Surface:
    """A strip that lies on a cylinder."""
    def place(u: np.ndarray, v: np.ndarray) -> Any:
        turn = 2 * math.pi * turns * u
        return radius * np.cos(turn), radius * np.sin(turn), rise * turns * u + width * v

    return grid(place, 120, 12)


def enneper(size: float) -> Surface:
    def place(u: np.ndarray, v: np.ndarray) -> Any:
        a, b = 1.6 * u - 0.8, 1.6 * v - 0.8
        x, y = a - a ** 3 / 3 + a * b * b, b - b ** 3 / 3 + b * a * a
        return size * x, size * y, size * (a * a - b * b)

    return grid(place, 50, 50)


def catenoid(size: float) -> Surface:
    """Half of it, so that it is a strip."""
    def place(u: np.ndarray, v: np.ndarray) -> Any:
        turn, z = math.pi * u, 2 * v - 1
        return size * np.cosh(z) * np.cos(turn), size * np.cosh(z) * np.sin(turn), size * z

    return grid(place, 70, 50)


def helicoid(size: float) -> Surface:
    def place(u: np.ndarray, v: np.ndarray) -> Any:
        turn, r = math.pi * (u - 0.5), 2 * v - 1
        return size * r * np.cos(turn), size * r * np.sin(turn), 0.9 * size * turn

    return grid(place, 50, 50)


TWENTY = [(x, y, 5.5) for x in (-32, -16, 0, 16, 32) for y in (-24, -8, 8, 24)]
SCAN = [(10, 8, 2.5), (-14, 10, 2.0), (0, -20, 3.0)]
MESHES: dict[str, Callable[[], Surface]] = {
    "folded once": lambda: sheet(lambda x, y: -0.5 * np.abs(x)),
    "folded sharply": lambda: sheet(lambda x, y: -1.0 * np.abs(x - 3)),
    "folded four times": lambda: sheet(zigzag(6, 16)),
    "ridge inside": lambda: sheet(lambda x, y: 9 * np.maximum(
        0, 1 - np.hypot(np.maximum(np.abs(x) - 10, 0), y) / 14)),
    "cone tip": lambda: sheet(lambda x, y: -0.9 * np.hypot(x, y), 35),
    "pyramid": lambda: sheet(lambda x, y: -0.7 * np.maximum(np.abs(x), np.abs(y)), 35),
    "narrow bump": lambda: sheet(lambda x, y: 14 * np.exp(-(x * x + y * y) / 60), 35),
    "helical strip": lambda: helix(30, 40, 60, 0.8),
    "long helical strip": lambda: helix(28, 30, 50, 1.6),
    "strips that cross": lambda: together(
        grid(lambda u, v: (100 * u - 50, 30 * v - 15, 0.004 * (100 * u - 50) ** 2), 60, 18),
        grid(lambda u, v: (15 - 30 * v, 100 * u - 50, 4 - 0.004 * (100 * u - 50) ** 2), 60, 18)),
    "scan with noise": lambda: noisy(sheet(bowl, 35, 70), 0.1),
    "scan with holes": lambda: noisy(with_holes(sheet(bowl, 35, 70), SCAN), 0.1),
    "decimated scan": lambda: decimated(noisy(sheet(bowl, 35, 60), 0.03)),
    "ragged scan": lambda: noisy(with_holes(sheet(bowl, 35, 70), [(40, 0, 18), (-38, 30, 12), *SCAN]), 0.15),
    "torus": lambda: shapes.ring(),
    "closed ball": lambda: shapes.sphere(30),
    "vase": lambda: shapes.vase(),
    "twenty holes": lambda: with_holes(sheet(lambda x, y: 0.003 * (x * x - y * y), 42, 84), TWENTY),
    "Enneper": lambda: enneper(45),
    "half catenoid": lambda: catenoid(24),
    "helicoid": lambda: helicoid(32),
    "monkey saddle": lambda: sheet(lambda x, y: (x ** 3 - 3 * x * y * y) / 3000, 35),
}
PARTS = ("bowl", "rounded_bowl", "lid", "lid_sharp_inside", "pipe", "tee", "loft", "plate")
CUT = {"torus": 4, "closed ball": 4, "vase": 2, "pipe": 1, "tee": 2, "loft": 1}  # --auto-cuts


def targets(folder: Path, only: Optional[set[str]]) -> dict[str, Path]:
    parts = [name for name in PARTS if only is None or name in only]
    found = dict(cad.make(folder, *parts)) if parts else {}
    for name, make in MESHES.items():
        if only is None or name in only:
            found[name] = folder / f"{name.replace(' ', '-')}.obj"
            found[name].write_text(shapes.obj_text(*make()), encoding="utf-8")
    return found


def check(path: Path, cuts: int, mend: str) -> str:
    parameters, request = native.Parameters(), CutRequest(suggested=cuts)
    parameters.set("mend", mend)
    given = {"source": find_source(str(path), will_be_cut=cuts > 0), "cut request": request}
    project = Project(path.stem, parameters, given, path.name)
    try:
        if cuts:
            project.give("cut request", request.accept(project.run(("cut search",))["cut search"]))
        return "yes" if project.run(("feasibility",))["feasibility"].feasible else "no"
    except CurveUpsError:
        return "refused"


def design(path: Path, out: Path, cuts: int, *settings: str) -> tuple[str, Optional[dict], float, str]:
    """Verdict, report, seconds, and the reason where it is not valid."""
    more = [*settings, *(["--auto-cuts", str(cuts)] if cuts else [])]
    begun = time.perf_counter()
    try:
        done = subprocess.run(command("design", path, "-o", out, "--no-solids", "--quiet", "--set", *more),
                              text=True, env=environment(), capture_output=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return "no end", None, LONGEST, f"more than {LONGEST} s"
    seconds = time.perf_counter() - begun
    if done.returncode > 1:
        error = done.stderr.strip().splitlines()[-1].replace("curveups: error: ", "")
        return "refused", None, seconds, error
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    return "valid" if report["valid"] else "no", report, seconds, "; ".join(report["reasons"][:1])


def row(name: str, path: Path, folder: Path) -> tuple[Any, ...]:
    cuts = CUT.get(name, 0)
    first, report, seconds, reason = design(path, folder / f"{path.stem}-out", cuts, "mend=on")
    second = ""
    for said in (report or {}).get("reasons", [reason]):
        advised = ADVICE.match(said) or ADVICE_OF_ERRORS.match(said)
        if advised:
            sizes = " ".join(filter(None, advised.groups())).split()
            again, *_ = design(path, folder / f"{path.stem}-advice", cuts, "mend=on", *sizes)
            second = f"{again}: {' '.join(sizes)}"
    block, deviation = (report or {}).get("mending", {}), (report or {}).get("deviation", {})
    moved, far = block.get("max_mm", math.nan), deviation.get("hausdorff_mm", math.nan)
    checked = check(path, cuts, "off"), check(path, cuts, "on")
    tiles = (report or {}).get("tiles", "-")
    figures = f"{moved:.2f}", f"{far:.2f}", f"{seconds:.1f}"
    return (name, *checked, tiles, first, second or "-", *figures, reason.split(" (")[0][:110])


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--only", type=lambda text: set(text.split(",")))
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    print("| target | check | mended | tiles | design | advice followed | moved | Hausdorff | s | why not |",
          "|---|---|---|---|---|---|---|---|---|---|", sep="\n")
    rows = []
    for name, path in targets(options.folder, options.only).items():
        rows.append(row(name, path, options.folder))
        print("| " + " | ".join(map(str, rows[-1])) + " |", flush=True)
    first = sum(one[4] == "valid" for one in rows)
    print(f"\nvalid from one command: {first} of {len(rows)}, "
          f"with their advice: {first + sum(one[5].startswith('valid') for one in rows)}")


if __name__ == "__main__":
    main()
