# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a built design fares whose materials are not what was entered: settles a target with materials drawn
from the ranges of the library.

    python tests/benchmarks/samples.py TARGET [--count N] [--set L=12 ...] [--tile NAME] [--keep FILE]

--keep gets a line for each sample as soon as it is known; a later run with the same options goes on after
them.

Each sample has a modulus and a thickness for either sheet, friction and the tiles' stiffness, drawn evenly
and independently from the ranges that the materials' files give. Prints how many hold, and of those that lie
inside the process window of the design (friction, and front against back) how many do not."""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Workbench"))

from curveups.base import profiles  # noqa: E402
from curveups.base.native import native  # noqa: E402
from curveups.project.project import Project  # noqa: E402
from curveups.stages import asked_by  # noqa: E402
from curveups.stages.cut_request import CutRequest  # noqa: E402
from curveups.stages.surface import find_source  # noqa: E402

WORDS = {True: "holds", False: "does not hold", None: "not known"}


def drawn(random: np.random.Generator, membrane: str, tile: str) -> dict[str, float]:
    """Parameters of one sample."""
    sheet, tiles = (profiles.sources(profiles.material_path(name)) for name in (membrane, tile))

    def one(source: dict[str, Any]) -> float:
        return float(random.uniform(source["low"], source["high"]))

    values = {f"{what}_{side}": one(sheet[what]) for side in ("front", "back")
              for what in ("shear_modulus", "thickness")}
    return {**values, **{name: one(tiles[name]) for name in ("friction_coefficient", "tile_modulus")}}


def inside(sample: dict[str, float], window: dict[str, Any]) -> bool:
    """Whether friction and what the front pulls against the back lie in the window."""
    pull = [sample[f"shear_modulus_{side}"] * sample[f"thickness_{side}"] for side in ("front", "back")]
    percent = 100 * (pull[0] / pull[1] - 1) if pull[0] > pull[1] else -100 * (pull[1] / pull[0] - 1)
    found = {"front_over_back": percent, "friction_coefficient": sample["friction_coefficient"]}
    for name, value in found.items():
        one = window[name]
        low, high = (one["searched"][k] if one[key] is None else one[key]
                     for k, key in enumerate(("low", "high")))
        if not low <= value <= high:
            return False
    return True


def _kept(options: argparse.Namespace, of: dict[str, Any]) -> list[dict[str, Any]]:
    """The samples that the file has, which is made where there is none."""
    if not options.keep:
        return []
    of = {**of, "membrane": options.membrane, "tile": options.tile}
    if not options.keep.exists():
        options.keep.write_text(json.dumps(of) + "\n", encoding="utf-8")
    first, *kept = options.keep.read_text(encoding="utf-8").splitlines()
    if first != json.dumps(of):
        sys.exit(f"{options.keep} has samples of other options: give another file")
    return [json.loads(line) for line in kept]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("target")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--membrane", default="latex-0.5")
    parser.add_argument("--tile", default="vero")
    parser.add_argument("--keep", type=Path, metavar="FILE")
    parser.add_argument("--set", nargs="*", default=[], metavar="name=value")
    options = parser.parse_args()
    values = native.Parameters()
    for text in (*options.set, "window=on"):
        values.set(*text.split("=", 1))
    meshed = Path(options.target).suffix != ""
    given = {"source": find_source(options.target, remesh=not meshed, will_be_cut=False),
             "cut request": CutRequest()}
    results = Project("samples", values, given, options.target).run(asked_by("solve", "settle"))
    window = {one["parameter"]: one for one in results["settle"].report().get("window", ())}
    print(f"{options.target}: {len(results.design.F)} tiles, {WORDS[results.verdict.holds]}; window "
          + ", ".join(f"{name} {one['low']} to {one['high']} of {one['searched']}"
                      for name, one in window.items()))
    random, count = np.random.default_rng(1), Counter[tuple[str, str]]()
    kept = _kept(options, {"target": options.target, "set": options.set, "window": window})
    for number in range(options.count if window else 0):
        sample = drawn(random, options.membrane, options.tile)
        if number < len(kept):
            count[kept[number]["where"], kept[number]["word"]] += 1
            continue
        parameters = native.Parameters(values)
        for name, value in {**sample, "margin": "off", "window": False}.items():
            parameters.set(name, value)
        settled = native.settle_design(results.design.with_parameters(parameters))
        where, word = "inside" if inside(sample, window) else "outside", WORDS[settled.holds]
        count[where, word] += 1
        if options.keep:
            with options.keep.open("a", encoding="utf-8") as file:
                file.write(json.dumps({"sample": sample, "where": where, "word": word}) + "\n")
    for (where, word), number in sorted(count.items()):
        print(f"{where} the window: {number} {word}")


if __name__ == "__main__":
    main()
