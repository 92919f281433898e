# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of length and thickness within which margins block no tile, each by bisection. Estimates:
project/size_choice.py finds sizes by solving."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable, Iterator, Optional

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding
from ..base.native import translated
from ..base.parameters import parameter, with_values
from .cut_request import CutRequest
from .division import all_cuts
from .feasibility import Feasibility, examine
from .stage import Inputs, Job, Result, Stage
from .target import remesh

# Lengths are tried up to this factor from the one that is set, those that make more tiles than there are up
# to MOST_TILES, and down to LEAST_TILES; thicknesses up to so many lengths.
FARTHEST, MOST_TILES, LEAST_TILES, THICKEST = 2.5, 1000, 12, 2.0


@dataclass(frozen=True)
class Limits(Result):
    """L: range of lengths, mm. H_body: largest thickness, mm. None where none was found; a mesh that is not
    remeshed has one length."""

    L: Optional[tuple[float, float]] = None
    H_body: Optional[float] = None
    remeshed: bool = True  # lengths were tried
    was_stopped: bool = False

    def findings(self, L: float, H_body: float) -> Iterator[Finding]:
        """Findings for tiles of this length and thickness, mm."""
        if self.was_stopped:
            return
        if self.L is not None:
            yield Finding.about("limits.L", H_body=H_body, low=self.L[0], high=self.L[1])
        elif self.remeshed:
            yield Finding.about("limits.no_L", H_body=H_body)
        if self.H_body is not None:
            yield Finding.about("limits.H_body", L=L, H_body=self.H_body)
        else:
            yield Finding.about("limits.no_H_body", L=L)
        yield Finding("limits.estimated")


def unhindered(margins: Feasibility) -> bool:
    """True where no obstacle depends on sizes: closed surfaces stay closed."""
    return all(obstacle.obstacle == "closed" for obstacle in margins.blocked)


def can_remesh(target: Any, cuts: CutRequest) -> bool:
    """True where a target may have another L: cuts by number belong to one mesh alone."""
    return target.own_length is None and not len(cuts.edges)


def length_of(tiles: float, target: Any) -> float:
    """Length L at which a target has about so many tiles, mm."""
    corners = target.source_V[target.source_F]
    double = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return math.sqrt(2 * float(double.sum()) / math.sqrt(3) / tiles)


def value_range(name: str) -> tuple[float, float]:
    row = parameter(name)
    return float(row.minimum), float(row.maximum)


def rounded(value: float) -> float:
    """Value rounded to two digits."""
    return float(f"{value:.2g}")


def limit(good: float, end: float, works: Callable[[float], bool]) -> float:
    """Last value that works between `good`, which does, and `end`, by bisection among round values."""
    if good == end or works(end):
        return end
    bad = end
    while True:
        middle = rounded(math.sqrt(good * bad))
        if not min(good, bad) < middle < max(good, bad):
            return good
        if works(middle):
            good = middle
        else:
            bad = middle


def _run(inputs: Inputs, job: Job) -> Limits:
    target, cuts, parameters = inputs["target"], inputs["cut request"], inputs.parameters
    L, H_body, as_set = parameters.get("L"), parameters.get("H_body"), unhindered(inputs["feasibility"])

    def thickness_works(value: float) -> bool:
        job.go_on(f"trying H_body = {value:g} mm")
        return unhindered(examine(inputs["target smoothing"].V, target.F, inputs["division"].edges,
                                  with_values(parameters, {"H_body": value})))

    def length_works(value: float) -> bool:
        job.go_on(f"trying L = {value:g} mm")
        values = with_values(parameters, {"L": value})
        try:
            with translated():
                mesh = remesh(target.source_V, target.source_F, value, values, job, target.creases)
                edges = all_cuts(cuts, mesh.V, mesh.F, values, job)
                return unhindered(examine(mesh.V, mesh.F, edges, values))
        except CurveUpsError:  # no mesh of tiles
            return False

    thinnest = max(value_range("H_body")[0], parameters.get("p_floor"))  # that a printer makes
    thickness = H_body if as_set else thinnest if thickness_works(thinnest) else None
    if thickness is not None:
        thickness = limit(thickness, rounded(THICKEST * L) if as_set else H_body, thickness_works)
    if not can_remesh(target, cuts):
        return Limits(None, thickness, False)
    least, most = value_range("L")
    longest = max(L, rounded(min(most, FARTHEST * L, length_of(LEAST_TILES, target))))
    shortest = min(L, rounded(max(least, L / FARTHEST, length_of(max(MOST_TILES, len(target.F)), target))))
    if as_set:
        lengths = limit(L, shortest, length_works), limit(L, longest, length_works)
    elif length_works(longest):
        lengths = limit(longest, L, length_works), longest
    else:
        return Limits(None, thickness)
    return Limits(lengths, thickness)


STAGE = Stage("sizes", ("target", "target smoothing", "cut request", "division", "feasibility"),
              frozenset({"target", "pieces", "tiles", "layout"}), _run,
              on_stop=lambda stage, inputs: Limits(was_stopped=True),
              label="Sizes", commands=("sizes",))
