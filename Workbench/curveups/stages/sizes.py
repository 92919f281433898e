# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes of tiles that work for a target: check names them beside what is set, `auto` chooses them, and errors
of a design advise them. size_search.py finds them."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any, Callable, Collection, Iterator, Mapping, Optional

from ..base.errors import CurveUpsError
from ..base.findings import Finding
from ..base.native import translated
from ..base.parameters import with_values
from ..base.value import Value
from .advice import Sizes, other_sizes
from .cut_request import CutRequest
from .division import all_cuts
from .feasibility import SAG, mending
from .size_search import ROUNDS, Candidate, SizeSearch
from .stage import Inputs, Job, Result, Stage, digest
from .trial_layout import FAILED, PASSED, UNDECIDED, TrialLayout

THICKEST = 2.0  # thicknesses are tried up to so many lengths
_THINNEST, _STOUTEST = 1 / 7, 3 / 7  # thicknesses are chosen between these lengths; the paper has 3/7
# How many lengths that do by estimates are tried then: each has another surface.
_ROUNDS_OF_LENGTHS = 1

_FACING = {"overlap", "bodies_overlap", "bodies_meet"}  # obstacles: parts that face one another

AUTOMATIC = ("L", "H_body")  # parameters that may be "auto"
READS = ("target", "cut request")  # what they are chosen by


@dataclass(frozen=True)
class Chosen(Value):
    """Values of parameters, mm, and what came of a trial layout with them: PASSED; FAILED, and no smaller
    ones were found with which one did not fail; else empty: estimates alone choose. beyond: as TrialLayout
    has it; then no smaller ones were found whose design is valid."""

    values: dict[str, float]
    trial: str
    beyond: tuple[Finding, ...] = ()


def choose(inputs: Inputs, names: Collection[str], job: Job) -> Chosen:
    """The largest feasible values of those of AUTOMATIC that are named, for inputs["target"] and
    inputs["cut request"]: lengths at which the surface stays within `maximum_deviation` of its tiles,
    thicknesses up to _STOUTEST lengths. A length is looked for with the thickness that is set or, where that
    is to be chosen, with _THINNEST lengths. Where a trial layout fails with them or is no valid design,
    smaller ones are tried: thicknesses, where both are to be chosen, unless membranes need another length.
    Raises CurveUpsError where there are none by estimates, and Stopped."""
    target, cuts, parameters = inputs["target"], inputs["cut request"], inputs.parameters
    if "L" in names and not _can_remesh(target, cuts):
        raise CurveUpsError("L can't be auto where the mesh is given", inputs.where,
                            "give cuts as polylines, or L as a number")
    search = SizeSearch(target, cuts, parameters, job)
    largest = _largest(search, parameters, names, inputs.where)

    def again() -> Optional[Sizes]:
        try:
            return tuple(_largest(search, parameters, names, inputs.where).items())
        except CurveUpsError:
            return None

    found = search.named(again, inputs)
    if found is None:
        return Chosen(largest, FAILED)
    sizes, layout = found
    return Chosen(dict(sizes), PASSED if layout.shown == PASSED else "", layout.beyond)


def _largest(search: SizeSearch, parameters: Any, names: Collection[str], where: str
             ) -> dict[str, float]:
    found: dict[str, float] = {}
    L, H_body, thin = parameters.get("L"), parameters.get("H_body"), search.thinnest
    if "L" in names:
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
    """Those of thickness, length and height of pins that would do for inputs["target"] without mending, by
    estimates, and how many were tried."""
    target, L, H_body = inputs["target"], inputs.parameters.get("L"), inputs.parameters.get("H_body")
    search = _unmended_search(target, cuts, inputs.parameters, job)
    thickness, pin = search.largest_thickness(L, H_body), search.height_of_pins(L, H_body)
    length = search.nearest_length(L, H_body) if _can_remesh(target, cuts) else None
    found = (_one("H_body", thickness), _one("L", length), _one("H_pin", pin),
             search.thinner_with_pins(L, H_body, thickness) if pin is None and length is None else None)
    return [one for one in found if one is not None], len(search.tried)


def _one(name: str, value: Optional[float]) -> Optional[Sizes]:
    return None if value is None else ((name, value),)


def _unmended_search(target: Any, cuts: CutRequest, parameters: Any, job: Job, sag: float = SAG
                     ) -> SizeSearch:
    """With mending a size takes up to ten seconds."""
    return SizeSearch(target, cuts, with_values(parameters, {"mend": "off"}), job, sag)


def _can_remesh(target: Any, cuts: CutRequest) -> bool:
    """Cuts by number are of one mesh alone."""
    return target.own_length is None and not len(cuts.edges)


@dataclass(frozen=True)
class Recommendation(Result):
    """Values that would do without mending, each of which was tried; None where none of those tried did, or
    where the mesh is given as it is. Where the sizes that are set do, these are limits by estimates: `L` has
    the ends of the range of lengths around the one that is set, of which every value tried did; `H_body` is
    the largest thickness, and no larger one than `thickest` was tried; `H_pin` is the least height of pins.
    Where they do not, each is a single value that no trial layout fails with: the length (twice) and the
    height of pins that are nearest to what is set, and the largest thickness, of those that were found."""

    L: Optional[tuple[float, float]]
    H_body: Optional[float]
    H_pin: Optional[float]
    thickest: float
    as_set: bool  # whether the sizes that are set do
    tried: tuple[tuple[float, float, float, int, bool], ...]  # L, H_body, H_pin, tiles, feasible
    together: Optional[tuple[float, float]] = None  # H_body and H_pin, which may do better than either
    estimated: bool = True  # whether some other sizes than those that are set do by estimates alone
    # By how much mend=on would move vertices so that those that are set do, mm; no trial layout fails then.
    # None where it is on, would not help, or is not needed.
    mending: Optional[float] = None
    # Why trial layouts of what is named are not valid all the same, by "L", "H_body", "H_pin", "together" and
    # "mend". Of H_body, H_pin and both together valid ones were looked for, and not found.
    beyond: Mapping[str, tuple[Finding, ...]] = field(default_factory=dict)

    @property
    def content(self) -> str:
        return digest(self.L, self.H_body, self.H_pin, self.together, self.mending, self.beyond)


def _run(inputs: Inputs, job: Job) -> Recommendation:
    target, cuts = inputs["target"], inputs["cut request"]
    L, H_body = inputs.parameters.get("L"), inputs.parameters.get("H_body")
    trial = inputs["trial layout"]
    search = _unmended_search(target, cuts, inputs.parameters, job, trial.sag)
    as_set = trial.sizes_do
    search.record(Candidate(L, H_body, inputs.parameters.get("H_pin"), len(target.F), as_set))
    most = max(THICKEST * L, H_body)
    remeshed = _can_remesh(target, cuts)
    estimated, beyond = [as_set], {}

    def noted(name: str, found: Optional[tuple[Any, TrialLayout]]) -> Any:
        """What was found, unless it is undecided; notes whether it is so by estimates alone, and why its
        design is not valid."""
        if found is None or found[1].shown == UNDECIDED:
            return None
        value, layout = found
        estimated.append(layout.shown != PASSED)
        if layout.beyond:
            beyond[name] = layout.beyond
        return value

    def named(name: str, find: Callable[[], Optional[Sizes]], rounds: int = ROUNDS) -> dict[str, float]:
        """What is named instead of sizes that do not do is tried; limits of those that do are estimates."""
        return dict((find() if as_set else noted(name, search.named(find, inputs, rounds))) or ())

    def length() -> Optional[Sizes]:
        ends = search.range_of_lengths(L, H_body) if remeshed else None
        return ends and _one("L", min(max(L, ends[0]), ends[1]))

    thickness = named("H_body", lambda: _one("H_body", search.largest_thickness(L, most))).get("H_body")
    if as_set:
        thickness = max(thickness or 0.0, H_body)
    near = named("L", length, _ROUNDS_OF_LENGTHS).get("L")
    lengths = None if near is None else search.range_of_lengths(L, H_body) if as_set else (near, near)
    pin = named("H_pin", lambda: _one("H_pin", search.height_of_pins(L, H_body))).get("H_pin")
    together: dict[str, float] = {}
    if not as_set and pin is None and lengths is None:
        if any(one.obstacle in _FACING for one in trial.blocked):
            together = named("together", lambda: search.thinner_with_pins(L, H_body, thickness))
        if thickness is None and not together:
            together = dict(noted("together", search.much_thinner(L, H_body, inputs)) or ())
        if together and "H_pin" not in together:
            thickness = together.pop("H_body")
            if "together" in beyond:
                beyond["H_body"] = beyond.pop("together")
    tried = tuple((one.L, one.H_body, one.H_pin, one.tiles, one.feasible) for one in search.tried.values())
    moved = None
    if not as_set:
        edges = all_cuts(cuts, target.V, target.F, inputs.parameters, job)
        moved = noted("mend", search.mending(target, edges, inputs))
    both = (together["H_body"], together["H_pin"]) if together else None
    return Recommendation(lengths, thickness, pin, most, as_set, tried, both, any(estimated), moved,
                          beyond)


STAGE = Stage("sizes", ("target", "cut request", "trial layout"),
              frozenset({"target", "pieces", "tiles", "layout", "bodies", "physics", "repair"}), _run,
              label="Other sizes", asked_by=("check",))
