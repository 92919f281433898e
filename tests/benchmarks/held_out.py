# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `curveups check` says beside what `curveups design` then finds, on targets drawn at random.

    python tests/benchmarks/held_out.py FOLDER [--first SEED] [--count N] [--table]

A seed gives one target and the sizes of its tiles, so that a range of seeds is a set. Limits of the check may
be looked at on the seeds below 1000 alone; those from 1000 on are held out, for its figure. FOLDER gets the
targets, and verdicts.jsonl with a line a seed: run again, it goes on where it ended. Prints how often check's
promise ("all of it can be tiles") was kept, and how often its refusal was right."""

from __future__ import annotations

import argparse
import json
import math
import sys
from pathlib import Path
from typing import Any, Callable

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import check_agrees  # noqa: E402
import shapes  # noqa: E402
from thirty_targets import Surface, grid, sheet  # noqa: E402

Random = np.random.Generator


def hills(random: Random) -> Surface:
    """A sheet with a few bumps and dents."""
    size = random.uniform(30, 45)
    bumps = [(*random.uniform(-0.8, 0.8, 2) * size, random.uniform(0.25, 0.7) * size,
              random.uniform(-0.35, 0.35) * size) for _ in range(random.integers(1, 5))]
    return sheet(lambda x, y: sum(height * np.exp(-((x - a) ** 2 + (y - b) ** 2) / wide ** 2)
                                  for a, b, wide, height in bumps), size)


def waves(random: Random) -> Surface:
    size, along, across = random.uniform(30, 45), *random.uniform(0, 2 * math.pi, 2)
    length, depth = random.uniform(40, 90), random.uniform(2, 12)
    return sheet(lambda x, y: depth * np.sin(2 * math.pi * (x * math.cos(along) + y * math.sin(along))
                                             / length + across), size)


def quadric(random: Random) -> Surface:
    a, b, c = random.uniform(-0.016, 0.016, 3)
    return sheet(lambda x, y: a * x * x + b * y * y + c * x * y, random.uniform(28, 45))


def revolved(random: Random) -> Surface:
    """A part of a surface of revolution, with a wavy profile."""
    radius, height = random.uniform(28, 50), random.uniform(50, 90)
    turns, wave, depth = random.uniform(0.3, 0.7), random.uniform(0.3, 1.5), random.uniform(0, 0.3)
    shift = random.uniform(0, 2 * math.pi)

    def place(u: np.ndarray, v: np.ndarray) -> Any:
        r = radius * (1 + depth * np.sin(2 * math.pi * wave * v + shift))
        return r * np.cos(2 * math.pi * turns * u), r * np.sin(2 * math.pi * turns * u), height * v

    return grid(place, 60, 50)


def cap(random: Random) -> Surface:
    """Of an ellipsoid."""
    a, b, c = random.uniform(30, 55, 3)
    rim = random.uniform(0.35, 0.6) * math.pi

    def place(u: np.ndarray, v: np.ndarray) -> Any:
        # The square onto a disc, without a corner in its middle.
        x, y = 2 * u - 1, 2 * v - 1
        p, q = x * np.sqrt(1 - y * y / 2), y * np.sqrt(1 - x * x / 2)
        polar = rim * np.hypot(p, q)
        share = np.divide(np.sin(polar), np.hypot(p, q), out=np.full_like(polar, rim), where=polar > 0)
        return a * share * p, b * share * q, c * np.cos(polar)

    return grid(place, 50, 50)


def twisted(random: Random) -> Surface:
    """A strip that turns about its middle line and bends."""
    long, wide = random.uniform(70, 120), random.uniform(40, 60)
    turn, bend = random.uniform(0, 1.6), random.uniform(0.1, 1.6)

    def place(u: np.ndarray, v: np.ndarray) -> Any:
        at, side = bend * (u - 0.5), wide * (v - 0.5)
        r, lean = long / bend, turn * (u - 0.5)
        return (r + side * np.sin(lean)) * np.sin(at), side * np.cos(lean), \
            (r + side * np.sin(lean)) * np.cos(at)

    return grid(place, 60, 40)


def creased(random: Random) -> Surface:
    """A sheet with a ridge or a valley that is rounded, and a bulge."""
    size, slope, round_ = random.uniform(30, 42), random.uniform(-0.6, 0.6), random.uniform(1, 15)
    bulge, along = random.uniform(-0.004, 0.004), random.uniform(0, math.pi)
    return sheet(lambda x, y: slope * np.sqrt((x * math.cos(along) + y * math.sin(along)) ** 2 + round_ ** 2)
                 + bulge * (x * x + y * y), size)


KINDS: tuple[Callable[[Random], Surface], ...] = (hills, waves, quadric, revolved, cap, twisted, creased)


def draw(seed: int) -> tuple[Surface, dict[str, Any]]:
    """A target and the parameters that differ from the defaults of check_agrees."""
    random = np.random.default_rng(seed)
    surface = KINDS[int(random.integers(len(KINDS)))](random)
    L = random.uniform(8.5, 11)
    # Proportions of a tile as users vary them.
    values = {"L": L, "H_body": L * random.uniform(0.25, 0.5), "H_pin": L * random.uniform(0.08, 0.2),
              "tau": random.uniform(2.2, 3.8)}
    return surface, {name: round(float(value), 2) for name, value in values.items()}


def counted(rows: list[dict[str, Any]]) -> list[str]:
    known = [row for row in rows if row["design"] is not None]
    promised, refused = ([row for row in known if bool(row["check"]) is said] for said in (True, False))
    kept = sum(bool(row["design"]) for row in promised)
    right = sum(not row["design"] for row in refused)
    lines = [f"{len(rows)} targets, {len(rows) - len(known)} without a verdict",
             f"promises kept: {kept} of {len(promised)}", f"refusals right: {right} of {len(refused)}"]
    return lines + [f"  seed {row['seed']}: {row['why']}" for row in promised if not row["design"]] \
        + [f"  seed {row['seed']}: refused ({', '.join(row['obstacles'])}), but valid" for row in refused
           if row["design"]]


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--first", type=int, default=1000)
    arguments.add_argument("--count", type=int, default=100)
    arguments.add_argument("--table", action="store_true")
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    file = options.folder / "verdicts.jsonl"
    rows = [json.loads(line) for line in file.read_text("utf-8").splitlines()] if file.exists() else []
    seeds = range(options.first, options.first + options.count)
    with file.open("a", encoding="utf-8") as out:
        for seed in seeds if not options.table else ():
            if any(row["seed"] == seed for row in rows):
                continue
            surface, values = draw(seed)
            path = options.folder / f"{seed}.obj"
            path.write_text(shapes.obj_text(*surface), encoding="utf-8")
            rows.append({"seed": seed, **values, **check_agrees.judge(str(path), 0, values)})
            print(json.dumps(rows[-1]), file=out, flush=True)
    print(*counted([row for row in rows if row["seed"] in seeds]), sep="\n")


if __name__ == "__main__":
    sys.exit(main())
