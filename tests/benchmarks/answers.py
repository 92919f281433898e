# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hands, other parameters and a moved target do for pieces that jam. `tools/bench --answers` runs it:
each row goes into its table of resources/docs/actuation.md as soon as it is known."""

from __future__ import annotations

import argparse
from typing import Any, Callable

from targets import solved, used

from bench_results import DOCS, renew
from curveups.base.errors import CurveUpsError
from curveups.project.compensation import compensate
from curveups.project.project import Project
from curveups.stages import HELP, RISEN, START
from curveups.stages.actuation import ActuationStart
from curveups.stages.actuation_help import ActuationHelp, Trial
from curveups.stages.stage import Job

# Of the built-in targets, with parameters that are not at their defaults.
DESIGNS: dict[str, tuple[str, dict[str, Any]]] = {
    "Half-Sphere, L = 14": ("half-sphere", {"L": 14}),
    "Saddle without bumps, L = 14": ("saddle", {"L": 14, "bumps": "none"}),
    "Ellipsoid cap, L = 14": ("ellipsoid-cap", {"L": 14}),
    "Hyperboloid, L = 14": ("hyperboloid", {"L": 14}),
    "Mask, L = 14": ("mask", {"L": 14}),
}
CHANGES = {"friction_coefficient": "friction {:.2g}", "d_gap_min": "gap {:.2g} mm",
           "H_body": "thickness {:.2g} mm"}
MOST_CHANGES = 3  # that a row names
ROUNDS = 2
Row = dict[str, Any]


def end(block: Row) -> str:
    """mm short, and open contacts."""
    if not block["converged"]:
        return "no answer"
    return f"{block['shortfall_mm']:.1f}, {len(block['open_contacts'])}"


def by_hand(project: Project) -> Row:
    project.give(START, ActuationStart(hands=True))
    return dict(project.run((RISEN,))[RISEN].report()["actuation"])


def hand_cells(row: Row) -> list[str]:
    path, found = end(row), row.get("by_hand")
    if found is None:
        return [path, *["-"] * 6]
    tiles = sum(len(touch["tiles"]) for touch in row["hands"])
    pressed = f"{tiles}, {row['hands'][0]['force_n']:g} N each" if tiles else "-"
    return [f"{path} of {row['contacts']}", f"{found['taps']} taps: {end(found['shaken'])}", pressed,
            end(found["end"]), found["reached"], f"{found['tried']}, up to {found['largest_force_n']:g} N",
            f"{row['processor']:.0f}"]


def compensated(project: Project) -> Row:
    return compensate(project.latest("design").design, ROUNDS, Job()).report()


def compensation_cells(row: Row) -> list[str]:
    rounds = [f"{mean:.3f}, {largest:.3f}" for mean, largest in zip(row["mean_mm"], row["max_mm"])]
    return [*rounds, *["-"] * (ROUNDS + 1 - len(rounds)), str(row["kept_round"]), f"{row['processor']:.0f}"]


def changed(project: Project) -> Row:
    results = project.run((HELP,))
    return {**results[RISEN].report()["actuation"], "helped": results[HELP]}


def help_cells(row: Row) -> list[str]:
    helped: ActuationHelp = row["helped"]
    best = [f"{_change(one)}: {one.shortfall:.1f}, {len(one.open_contacts)}" for one in helped.nearer]
    none = sum(one.valid and one.arrives is None for one in helped.trials)
    return [f"{end(row)} of {row['contacts']}", "; ".join(best[:MOST_CHANGES]) or "none",
            f"{len(helped.trials)}, {sum(one.valid for one in helped.trials)}, {none}",
            f"{row['processor']:.0f}"]


def _change(trial: Trial) -> str:
    words = [CHANGES[name].format(value) if name in CHANGES else {"none": "no bumps"}.get(value, value)
             for name, value in trial.change.values.items()]
    return ", ".join([*words, *(["a cut"] if len(trial.change.edges) else [])])


TABLES: dict[str, tuple[Callable[[Project], Row], Callable[[Row], list[str]]]] = {
    "by hand": (by_hand, hand_cells), "compensation": (compensated, compensation_cells),
    "changes": (changed, help_cells)}


def main() -> None:
    parser = argparse.ArgumentParser(prog="tools/bench --answers", description=__doc__)
    parser.add_argument("--only", metavar="TARGET;...", help=f"of {'; '.join(DESIGNS)}")
    parser.add_argument("--table", choices=TABLES, action="append", help="by default all")
    options = parser.parse_args()
    names = options.only.split(";") if options.only else list(DESIGNS)
    if unknown := [name for name in names if name not in DESIGNS]:
        parser.error(f"unknown design {unknown[0]}: there are {'; '.join(DESIGNS)}")
    for name in names:
        target, values = DESIGNS[name]
        for table in options.table or TABLES:
            run, cells = TABLES[table]
            project, begun = solved(target, **values), used()
            try:
                row = {**run(project), "name": name}
            except CurveUpsError as error:
                print(f"{name}, {table}: {error}", flush=True)
                continue
            row["processor"] = used() - begun
            renew([row], DOCS / "actuation.md", {table: cells})
            print(f"{name}, {table}: {', '.join(cells(row))}", flush=True)


if __name__ == "__main__":
    main()
