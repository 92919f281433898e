# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `curveups check` says beside what `curveups design` then finds, on targets drawn at random.

    python tests/benchmarks/held_out.py FOLDER [--first SEED] [--count N] [--table] [--named]

A seed gives one target and the sizes of its tiles, so that a range of seeds is a set. Sets are kept apart by
this rule: whoever works on the check may look at the seeds below 1000, and at no other. A range from 1000
on serves for one figure and is spent then, whatever came of it: the next figure takes seeds that no run had
before. Spent are 1000 to 1099 and 2000 to 2119, and 3000 to 3119 and 7200 to 7519 for the figures of
resources/docs/feasibility.md.

Check promises two things. "Feasible": the design ends without a reason of a kind that check covers
(COVERED). "Not feasible": the design fails. FOLDER gets the targets, and verdicts.jsonl with a line a seed:
run again, it goes on where it ended. Prints how often each promise was kept.

--named counts a third promise, into named.jsonl: what check names instead of sizes that do not do (another
L, H_body or H_pin, H_body and H_pin together, or mend=on) does. Its targets are those of SHARP that a seed
gives, without mending, with tiles up to as thick as they are long: else few need other sizes. Spent for the
figures of resources/docs/feasibility.md are 4200 to 4399, 6000 to 6199, 7000 to 7119 and 7600 to 7699; 4000
to 4199 and 5000 to 5199 are spent, too."""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))

import check_agrees  # noqa: E402
import shapes  # noqa: E402
from curveups.base.errors import CurveUpsError, Stopped  # noqa: E402
from curveups.stages import trial_layout  # noqa: E402
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


def tip(random: Random) -> Surface:
    """A cone or a pyramid with a rounded tip."""
    size, slope, round_ = random.uniform(28, 38), random.uniform(-1, 1), random.uniform(0.3, 8)
    power = 2 if random.uniform() < 0.6 else 8  # the norm whose level lines are circles, or nearly squares
    return sheet(lambda x, y: slope * np.sqrt(((x / size) ** power + (y / size) ** power) ** (2 / power)
                                              * size ** 2 + round_ ** 2), size)


def pleats(random: Random) -> Surface:
    """Ridges and valleys side by side, which end within the sheet or run through it."""
    size, width, depth = random.uniform(30, 42), random.uniform(11, 22), random.uniform(2, 10)
    sharp, inside = random.uniform(0.6, 0.99), random.uniform() < 0.5
    return sheet(lambda x, y: depth * np.arcsin(sharp * np.cos(math.pi * x / width)) / math.asin(sharp)
                 * (np.exp(-(y / (0.5 * size)) ** 4) if inside else 1), size)


def bent(random: Random) -> Surface:
    """A strip bent round a small radius by up to a half turn, so that its ends face one another."""
    radius, turn = random.uniform(3, 16), random.uniform(0.4, 1) * math.pi
    straight, wide = random.uniform(20, 35), random.uniform(40, 55)
    long = 2 * straight + radius * turn

    def place(u: np.ndarray, v: np.ndarray) -> Any:
        along = long * u - straight
        angle = np.clip(along / radius, 0, turn)
        rest = np.minimum(along, 0) + np.maximum(along - radius * turn, 0)
        return (radius * np.sin(angle) + rest * np.cos(angle), wide * v,
                radius * np.cos(angle) - rest * np.sin(angle))

    return grid(place, 90, 40)


KINDS: tuple[Callable[[Random], Surface], ...] = (hills, waves, quadric, revolved, cap, twisted, creased, tip,
                                                  pleats, bent)
SHARP = (waves, creased, tip, pleats, bent)


COVERED = trial_layout.COVERED | {"refused"}  # kinds of reasons that check looks for


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
    broken = [row for row in promised if COVERED & set(row["reasons"])]
    wrong = [row for row in refused if row["design"]]
    kept = len(known) - len(broken) - len(wrong)
    valid = sum(bool(row["design"]) for row in promised)
    seconds = sorted(row["check_seconds"] for row in known if row["check_seconds"] is not None)
    return [f"{len(rows)} targets, {len(rows) - len(known)} without a verdict",
            f"promises kept: {kept} of {len(known)}",
            f"  feasible: {len(promised) - len(broken)} of {len(promised)}, of which {valid} valid",
            f"  not feasible: {len(refused) - len(wrong)} of {len(refused)}",
            *(f"check, s: {seconds[len(seconds) // 2]} in the median, {seconds[-1]} at most"
              for _ in seconds[:1]),
            *(f"  seed {row['seed']}: {row['why']}" for row in promised if not row["design"]),
            *(f"  seed {row['seed']}: refused ({', '.join(row['obstacles'])}), but valid" for row in wrong)]


def judge_named(seed: int, folder: Path) -> Optional[dict[str, Any]]:
    """What check names where the sizes that are set do not do, and what design then finds; None where the
    seed's target is not of SHARP."""
    if KINDS[int(np.random.default_rng(seed).integers(len(KINDS)))] not in SHARP:
        return None
    surface, values = draw(seed)
    thick = np.random.default_rng([seed, 1]).uniform(0.45, 1.0)
    values.update(H_body=round(values["L"] * float(thick), 2), mend="off")
    path = _written(folder, seed, surface)
    begun = time.process_time()
    try:
        job = check_agrees.job_of(begun)
        sizes = check_agrees.made(path, 0, values, job).run(("sizes",), job)["sizes"]
        seconds = round(time.process_time() - begun, 1)
    except (CurveUpsError, Stopped) as error:
        return {"seed": seed, **values, "as_set": None, "why": str(error), "named": {}}
    named = {name: {**option, "said_valid": not sizes.estimated and name not in sizes.beyond,
                    **_designed(path, {**values, **option})}
             for name, option in _options(sizes).items()}
    return {"seed": seed, **values, "as_set": sizes.as_set,
            "estimated": sizes.estimated, "check_seconds": seconds, "named": named}


def _options(sizes: Any) -> dict[str, dict[str, Any]]:
    if sizes.as_set:
        return {}
    found = {"L": {"L": sizes.L[0]} if sizes.L else None,
             "H_body": {"H_body": sizes.H_body} if sizes.H_body else None,
             "H_pin": {"H_pin": sizes.H_pin} if sizes.H_pin else None,
             "together": dict(zip(("H_body", "H_pin"), sizes.together)) if sizes.together else None,
             "mend": {"mend": "on"} if sizes.mending is not None else None}
    return {name: option for name, option in found.items() if option}


def _designed(path: str, values: dict[str, Any]) -> dict[str, Any]:
    job = check_agrees.job_of(time.process_time())
    try:
        said = check_agrees.designed(check_agrees.made(path, 0, values, job), job)
    except CurveUpsError as error:
        return {"design": False, "why": error.what, "reasons": ["refused"]}
    except Stopped:
        return {"design": None, "why": "", "reasons": []}
    return {**said, "design": None if job.stopped else said["design"]}


def counted_named(rows: list[dict[str, Any]]) -> list[str]:
    without = [row for row in rows if row["as_set"] is False]
    named = [(row, name, one) for row in without for name, one in row["named"].items()
             if one["design"] is not None]
    lines = [f"{len(rows)} targets, {sum(row['as_set'] is None for row in rows)} without an answer",
             f"the sizes that are set do not do for {len(without)}, and for "
             f"{sum(not row['named'] for row in without)} of these nothing is named"]
    for kind in (*dict.fromkeys(name for _, name, _ in named), None):
        of = [one for _, name, one in named if kind in (name, None)]
        kept = sum(not COVERED & set(one["reasons"]) for one in of)
        lines.append(f"{kind or 'all'}: kept {kept} of {len(of)}, {sum(one['design'] for one in of)} valid")
    sound = [one for _, _, one in named if one["said_valid"]]
    lines.append(f"said to be valid: {sum(one['design'] for one in sound)} of {len(sound)}")
    return lines + [f"  seed {row['seed']}, {name}: {one['why']}" for row, name, one in named
                    if COVERED & set(one["reasons"])]


def _written(folder: Path, seed: int, surface: Surface) -> str:
    path = folder / f"{seed}.obj"
    path.write_text(shapes.obj_text(*surface), encoding="utf-8")
    return str(path)


def judge(seed: int, folder: Path) -> dict[str, Any]:
    surface, values = draw(seed)
    return {"seed": seed, **values, **check_agrees.judge(_written(folder, seed, surface), 0, values)}


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--first", type=int, default=0)
    arguments.add_argument("--count", type=int, default=100)
    arguments.add_argument("--table", action="store_true")
    arguments.add_argument("--named", action="store_true")
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    file = options.folder / ("named.jsonl" if options.named else "verdicts.jsonl")
    rows = [json.loads(line) for line in file.read_text("utf-8").splitlines()] if file.exists() else []
    seeds = range(options.first, options.first + options.count)
    with file.open("a", encoding="utf-8") as out:
        for seed in seeds if not options.table else ():
            if any(row["seed"] == seed for row in rows):
                continue
            row = (judge_named if options.named else judge)(seed, options.folder)
            if row:
                rows.append(row)
                print(json.dumps(row), file=out, flush=True)
    count = counted_named if options.named else counted
    print(*count([row for row in rows if row["seed"] in seeds]), sep="\n")


if __name__ == "__main__":
    sys.exit(main())
