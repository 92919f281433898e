# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes of tiles that work for a target: those that check names, those that errors name, and those that are
chosen where parameters are auto. They are found by trying them (size_search.py)."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Collection, Iterator, Optional

from ..base.errors import CurveUpsError
from ..base.native import native, translated
from .advice import Sizes, other_sizes
from .cut_request import CutRequest
from .division import all_cuts
from .feasibility import mending
from .size_search import THICKEST, Candidate, ParameterSearch
from .stage import Inputs, Job, Result, Stage, digest

_THINNEST, _STOUTEST = 1 / 7, 3 / 7  # of chosen thicknesses, in lengths (the paper's tiles have 3/7)
AUTOMATIC = ("L", "H_body")  # parameters that may be "auto"


def choose(target: Any, cuts: CutRequest, parameters: Any, names: Collection[str], job: Job,
           where: str) -> dict[str, float]:
    """The largest feasible values of those of AUTOMATIC that are named: lengths at which the surface stays
    within `maximum_deviation` of its tiles, thicknesses up to _STOUTEST lengths. A length is looked for with
    the thickness that is set or, where that is to be chosen, with _THINNEST lengths. Raises CurveUpsError
    where there is none, and Stopped."""
    found: dict[str, float] = {}
    search = _search(target, cuts, parameters, job)
    L, H_body = parameters.get("L"), parameters.get("H_body")
    if "L" in names:
        if not _can_remesh(target, cuts):
            raise CurveUpsError("L can't be auto where the mesh is given", where,
                                "give cuts as polylines, or L as a number")
        thin = search.thinnest
        thickness = (lambda L: max(_THINNEST * L, thin)) if "H_body" in names else (lambda L: H_body)
        L = found["L"] = search.largest_length(L, thickness, parameters.get("maximum_deviation"), where)
    if "H_body" in names:
        thickest = search.largest_thickness(L, _STOUTEST * L)
        if thickest is None:
            raise CurveUpsError(f"no thickness up to {_STOUTEST * L:.3g} mm does for L = {L:g} mm", where,
                                "see 'curveups check'")
        found["H_body"] = thickest
    return found


@contextmanager
def with_advice(inputs: Inputs, cuts: CutRequest, job: Job) -> Iterator[None]:
    """Errors that are raised inside say, besides, which other size would do for inputs["target"]."""
    try:
        with translated(inputs.where):
            yield
    except CurveUpsError as error:
        raise CurveUpsError(error.what, error.where, f"{error.remedy}; {_advice(inputs, cuts, job)}",
                            error.status, error.tiles, error.finding) from error


def _advice(inputs: Inputs, cuts: CutRequest, job: Job) -> str:
    target, parameters = inputs["target"], inputs.parameters
    options, tried = sizes_that_do(inputs, cuts, job)
    edges = all_cuts(cuts, target.V, target.F, parameters, job)
    return other_sizes(options, tried, mending(target.V, target.F, edges, parameters, job),
                       parameters.get("mend") == "on")


def sizes_that_do(inputs: Inputs, cuts: CutRequest, job: Job) -> tuple[list[Sizes], int]:
    """Those of thickness, length and height of pins that would do for inputs["target"] without mending, and
    how many were tried."""
    target, L, H_body = inputs["target"], inputs.parameters.get("L"), inputs.parameters.get("H_body")
    search = _unmended_search(target, cuts, inputs.parameters, job)
    found = {"H_body": search.thickness_that_holds(L, H_body)}
    if _can_remesh(target, cuts):
        found["L"] = search.nearest_length(L, H_body)
    found["H_pin"] = search.least_pin(L, H_body)
    options: list[Sizes] = [((name, value),) for name, value in found.items() if value is not None]
    if found["H_pin"] is None and found.get("L") is None:
        together = search.thinner_with_pins(L, H_body, found["H_body"])
        options += [tuple(zip(("H_body", "H_pin"), together))] if together else []
    return options, len(search.made)


def _unmended_search(target: Any, cuts: CutRequest, parameters: Any, job: Job) -> ParameterSearch:
    """With mending a size takes up to ten seconds."""
    unmended = native.Parameters(parameters)
    unmended.set("mend", "off")
    return _search(target, cuts, unmended, job)


def _search(target: Any, cuts: CutRequest, parameters: Any, job: Job) -> ParameterSearch:
    search = ParameterSearch(target.source_V, target.source_F, cuts, parameters, job, target.creases)
    search.start_from(parameters.get("L"), target)
    return search


def _can_remesh(target: Any, cuts: CutRequest) -> bool:
    """Cuts by number are of one mesh alone."""
    return target.own_length is None and not len(cuts.edges)


@dataclass(frozen=True)
class Recommendation(Result):
    """Values that would do without mending, each of which was laid out; those that are set may do with it.
    `L`: the ends of a range of lengths with the thickness that is set; it holds the length that is set, or is
    the nearest to it, and every value tried between its ends did. `H_body`: the largest thickness with the
    length that is set. `H_pin`: the least height of pins with both that are set, where the set one does;
    else that of the nearest range of heights that do. None where none of those tried did, or where the mesh
    is given as it is. `thickest`: no larger ones were tried."""

    L: Optional[tuple[float, float]]
    H_body: Optional[float]
    H_pin: Optional[float]
    thickest: float
    as_set: bool  # whether the sizes that are set do
    tried: tuple[tuple[float, float, float, int, bool], ...]  # L, H_body, H_pin, tiles, feasible
    together: Optional[tuple[float, float]] = None  # H_body and H_pin, where no other L or H_pin does

    @property
    def content(self) -> str:
        return digest(self.L, self.H_body, self.H_pin, self.together)


def _run(inputs: Inputs, job: Job) -> Recommendation:
    target, cuts = inputs["target"], inputs["cut request"]
    L, H_body = inputs.parameters.get("L"), inputs.parameters.get("H_body")
    search = _unmended_search(target, cuts, inputs.parameters, job)
    as_set = not {one.obstacle for one in inputs["feasibility"].blocked} - {"closed"}
    as_it_is = Candidate(L, H_body, inputs.parameters.get("H_pin"), len(target.F), as_set)
    search.made[L, H_body, as_it_is.H_pin] = as_it_is
    search.decided.add((L, H_body, as_it_is.H_pin))  # as far as it can be
    most = max(THICKEST * L, H_body)
    thickness = search.thickness_that_holds(L, most, H_body if as_set else 0.0)
    lengths = search.range_of_lengths(L, H_body) if _can_remesh(target, cuts) else None
    pin = search.least_pin(L, H_body)
    together = search.thinner_with_pins(L, H_body, thickness) if pin is None and lengths is None else None
    tried = tuple((one.L, one.H_body, one.H_pin, one.tiles, one.feasible) for one in search.made.values())
    return Recommendation(lengths, thickness, pin, most, as_set, tried, together)


STAGE = Stage("sizes", ("target", "cut request", "feasibility"),
              frozenset({"target", "pieces", "tiles", "layout", "repair"}), _run,
              label="Other sizes", asked_by=("check",))
