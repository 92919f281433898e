# SPDX-License-Identifier: LGPL-2.1-or-later
"""Searches for sizes of tiles that work for a target, by trying them: the surface is remeshed at other L and
given other thicknesses and pins, and examined as a design would be (feasibility.py). Trial layouts decide
about what is named (trial_layout.py)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Callable, Mapping, Optional, Sequence, TypeVar

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.native import translated
from ..base.parameters import parameter, with_values
from .advice import Sizes
from .cut_request import CutRequest
from .division import all_cuts
from .feasibility import SAG, mending, sizes_do
from .stage import Inputs, Job
from .target import remesh
from .trial import REPAIR_STEPS
from .trial_layout import STOUTEST, TrialLayout, decide

# Lengths and heights of pins are tried up to this factor from the one that is set, lengths as long as that
# makes no more tiles than these or than there are.
FARTHEST, MOST_TILES, LEAST_TILES = 2.5, 1000, 12
MOST_CHOSEN = 5000  # as long as there are no more tiles a length is chosen
_Value = TypeVar("_Value")
ROUNDS = 3  # how many of one kind that do by estimates are tried then, at most
_SIZES = ("L", "H_body", "H_pin")
# Parts of the thickness and of the height of pins that are set.
_THINNER = ((1 / 2, 1.0), (1 / 2, 1.5), (1 / 4, 1.0), (1 / 4, 1.5))
# Steps of repair for all trial layouts of a search: what needs more is undecided then.
_MOST_STEPS = 10 * REPAIR_STEPS
# Sizes are near those of a trial that failed where none differs by a larger factor; of the next that fails by
# its square.
_NEAR = 1.15
_STRIDE = 6  # values of the series from one trial to the next, before the ends are narrowed down


def series(low: float, high: float) -> list[float]:
    """Round lengths from low to high, mm, each at least some 3 % more than the one before."""
    values: list[float] = []
    for exact in np.geomspace(low, high, 2 + int(math.log(max(high / low, 1.0)) / 0.035)):
        digits = max(0, 1 - math.floor(math.log10(exact)))
        value = round(float(exact), digits)
        if low <= value <= high and (not values or value > values[-1]):
            values.append(value)
    return values


@dataclass(frozen=True)
class Candidate:
    """What came of one size."""

    L: float
    H_body: float
    H_pin: float
    tiles: int
    feasible: bool


class SizeSearch:
    """Sizes on the surface of a Target, made with the L of the parameters. What can't be remeshed or has no
    tiles is not feasible; only stopping ends the search. `sag`: as sizes_do has it."""

    def __init__(self, target: Any, cuts: CutRequest, parameters: Any, job: Job, sag: float = SAG):
        self._target, self._cuts = target, cuts
        self._outer, self._job, self._trying = job, Job(self._tell), ""
        self._parameters, self._least_sag, self._sag = parameters, sag, sag
        self.thinnest = max(value_range("H_body")[0], parameters.get("p_floor"))  # that a printer makes
        self.tried: dict[tuple[float, ...], Candidate] = {}   # by L, H_body, H_pin
        self._known: dict[tuple[float, ...], Candidate] = {}  # of these what holds for the next sizes, too
        self._decided: dict[tuple[float, ...], Candidate] = {}  # by trial layouts
        self._steps = _MOST_STEPS
        self._failed: list[tuple[np.ndarray, float]] = []  # L, H_body, H_pin; the factor of what is near
        self._chord_errors: dict[float, float] = {}
        corners = target.source_V[target.source_F]
        self._area = float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                                   corners[:, 2] - corners[:, 0]), axis=1).sum() / 2)
        self._mesh = lru_cache(maxsize=1)(self._remesh)  # thicknesses are tried on one mesh

    def tiles(self, L: float) -> float:
        """About how many tiles of this length there would be."""
        return self._area / (math.sqrt(3) / 4 * L * L)

    def __call__(self, L: float, H_body: float, H_pin: Optional[float] = None) -> Candidate:
        """H_pin: else as it is set."""
        size = (L, H_body, float(self._parameters.get("H_pin") if H_pin is None else H_pin))
        known = self._decided.get(size) or self._known.get(size)
        if known is not None:
            return known
        if any(np.all(np.abs(np.log(np.array(size) / one)) < math.log(factor))
               for one, factor in self._failed):
            return Candidate(*size, 0, False)
        self._say("trying " + ", ".join(f"{name} = {value:g} mm" for name, value in zip(_SIZES, size)))
        self.tried[size] = self._known[size] = self._try(*size)
        return self._known[size]

    def record(self, one: Candidate) -> None:
        """Takes what came of a size otherwise, for good."""
        size = (one.L, one.H_body, one.H_pin)
        self.tried[size] = self._decided[size] = one

    def named(self, find: Callable[[], Optional[Sizes]], inputs: Inputs, rounds: int = ROUNDS
              ) -> Optional[tuple[Sizes, TrialLayout]]:
        """The first sizes that `find` names by estimates and whose trial layout is a valid design, and that
        layout. Else the first that pass, those of which no trial can be made, or those that are undecided;
        None where `find` finds none, or so many have failed. After each that is not valid, those near it are
        left out, and others have to give membranes more clearance where that was the reason. What the next
        `find` asks for has nothing to do with it."""
        if self._failed:
            self._failed, self._sag = [], self._least_sag
            self._known.clear()
        best: Optional[tuple[Sizes, TrialLayout]] = None
        for attempt in range(1, rounds + 1):
            sizes = find()
            if sizes is None:
                break
            found = self._trial(sizes, inputs)
            if found is not None and found.does and not found.beyond:
                return best if best and best[1].does and not found.shown else (sizes, found)
            L, H_body, H_pin = size = tuple(float(dict(sizes).get(name, self._parameters.get(name)))
                                            for name in _SIZES)
            if found is not None and found.sizes_do:
                best = best if best and best[1].does >= found.does else (sizes, found)
            else:
                self.record(Candidate(L, H_body, H_pin, self(*size).tiles, False))
            self._failed.append((np.array(size), _NEAR ** attempt))
            self._sag = max(self._sag, found.sag if found else SAG)
            # What is not feasible stays so.
            self._known = {one: made for one, made in self._known.items() if not made.feasible}
        return best

    def much_thinner(self, L: float, H_body: float, inputs: Inputs) -> Optional[tuple[Sizes, TrialLayout]]:
        """The first of _THINNER whose trial layout is a valid design, else the first that pass, and that
        layout; None where none do. Membranes clear thin tiles under high pins."""
        best: Optional[tuple[Sizes, TrialLayout]] = None
        H_pin, highest = self._parameters.get("H_pin"), value_range("H_pin")[1]
        for thinner, higher in _THINNER:
            body = float(f"{thinner * H_body:.2g}")
            pin = H_pin if higher == 1 else float(f"{higher * H_pin:.3g}")
            if body < self.thinnest or pin > highest or (L, body, pin) in self._decided:
                continue
            sizes = (("H_body", body), *((("H_pin", pin),) if higher > 1 else ()))
            found = self._trial(sizes, inputs)
            does = found is not None and found.does
            self.record(Candidate(L, body, pin, len(self._mesh(L)[1]), does))
            if found is not None and does:
                best = best or (sizes, found)
                if not found.beyond:
                    return sizes, found
        return best

    def mending(self, target: Any, edges: np.ndarray, inputs: Inputs
                ) -> Optional[tuple[float, TrialLayout]]:
        """By how much (mm) mend=on would move vertices so that the sizes that are set pass a trial layout,
        and that. None: mend=on is set, or would not help."""
        self._say("trying mend=on")
        moved = mending(target.V, target.F, edges, inputs.parameters, self._job, self._least_sag)
        found = None if moved is None else self._made({"mend": "on"}, inputs)
        return (moved, found) if moved is not None and found is not None and found.does else None

    def _trial(self, sizes: Sizes, inputs: Inputs) -> Optional[TrialLayout]:
        self._say("trying " + ", ".join(f"{name} = {value:g} mm" for name, value in sizes))
        return self._made({**dict(sizes), "mend": self._parameters.get("mend")}, inputs)

    def _made(self, values: Mapping[str, Any], inputs: Inputs) -> Optional[TrialLayout]:
        """Makes a trial layout, also where estimates are in no doubt. None where the project refuses the
        target with these values."""
        assert inputs.elsewhere is not None
        steps = [min(REPAIR_STEPS, self._steps)]
        self._steps -= steps[0]
        try:
            found = inputs.elsewhere(values, ("feasibility",), self._job)
            return decide(inputs, found["feasibility"], self._job, values, steps, found)
        except CurveUpsError:
            return None
        finally:
            self._steps += max(0, steps[0])

    def chord_error(self, L: float) -> float:
        """Largest distance of the surface from its facets, mm; NaN where it can't be remeshed."""
        if L not in self._chord_errors:
            self._say(f"trying L = {L:g} mm")
            try:
                with translated():
                    self._chord_errors[L] = self._mesh(L)[2]
            except CurveUpsError:
                self._chord_errors[L] = math.nan
        return self._chord_errors[L]

    def _say(self, trying: str) -> None:
        self._trying = trying
        if not self._tell():
            raise Stopped

    def _tell(self, *_: Any) -> bool:
        """Of a trial's own work nothing is told: its fraction is none of the search, whose end is unknown."""
        return self._outer(self._trying)

    def _try(self, L: float, H_body: float, H_pin: float) -> Candidate:
        values = with_values(self._parameters, {"L": L, "H_body": H_body, "H_pin": H_pin})
        tiles = 0
        try:
            with translated():
                V, F, _ = self._mesh(L)
                tiles = len(F)
                edges = all_cuts(self._cuts, V, F, values, self._job)
                feasible = sizes_do(V, F, edges, values, self._job, self._sag)
        except CurveUpsError:
            feasible = False
        return Candidate(L, H_body, H_pin, tiles, feasible)

    def _remesh(self, L: float) -> tuple[np.ndarray, np.ndarray, float]:
        made = self._target
        if L != self._parameters.get("L"):
            made = remesh(made.source_V, made.source_F, L, self._parameters, self._job, made.creases)
        return made.V, made.F, float(made.chord_error)

    def largest_thickness(self, L: float, most: float) -> Optional[float]:
        """The largest feasible thickness of a series from `thinnest` to `most`, found by bisection; None
        where the least has no tiles either."""
        values = series(self.thinnest, most)
        found = _last(values, lambda H_body: self(L, H_body).feasible)
        return None if found < 0 else values[found]

    def largest_length(self, L: float, thickness: Callable[[float], float], maximum_deviation: float,
                       where: str) -> float:
        """The largest feasible length that was tried at which the surface stays within `maximum_deviation`
        (mm) of its facets; L: one that was tried. Raises CurveUpsError where there is none."""
        low, high = value_range("L")
        values = [value for value in series(low, high) if LEAST_TILES <= self.tiles(value) <= MOST_CHOSEN]
        if not values:
            raise CurveUpsError("the surface is too large or too small for tiles", where,
                                "check its unit (scale)")

        def near(value: float) -> bool:
            return self.chord_error(value) <= maximum_deviation

        # It grows with the square of the length, as long as that is small against the curvature's radius.
        chord_error = self.chord_error(L)
        guess = L * math.sqrt(maximum_deviation / chord_error) if chord_error > 0 else values[-1]
        place = int(np.argmin(np.abs(np.log(np.array(values) / guess))))
        while place > 0 and not near(values[place]):
            place = max(0, place - _STRIDE // 2)
        last = _reach(values, place, place, near, 1) if near(values[place]) else -1
        for place in range(last, -1, -1):
            if near(values[place]) and self(values[place], thickness(values[place])).feasible:
                return values[place]
        raise CurveUpsError(f"no L does that keeps tiles within {maximum_deviation:g} mm of the surface",
                            where, "raise maximum_deviation, or see 'curveups check'")

    def lengths(self, L: float, H_body: float) -> list[float]:
        """The series of lengths about L, with L itself in it, down to the thickness: no trial layout is made
        of tiles that are thicker than long."""
        most, least = max(MOST_TILES, self.tiles(L)), min(L, H_body / STOUTEST)
        return [value for value in _about("L", L) if value == L or (
            value >= least and LEAST_TILES <= self.tiles(value) <= most)]

    def nearest_length(self, L: float, H_body: float) -> Optional[float]:
        """The feasible length nearest to L, of every _STRIDE-th of the series and both ends."""
        # Fewer tiles first: that is quicker.
        return _nearest(self.lengths(L, H_body), L, lambda value: self(value, H_body).feasible)

    def range_of_lengths(self, L: float, H_body: float) -> Optional[tuple[float, float]]:
        """Ends of the range of feasible lengths that holds L, or of the nearest one; both were tried."""
        start, values = self.nearest_length(L, H_body), self.lengths(L, H_body)
        if start is None:
            return None
        first = values.index(start)

        def feasible(value: float) -> bool:
            return self(value, H_body).feasible

        low, high = (values[_reach(values, values.index(L), first, feasible, step)] for step in (-1, 1))
        return low, high

    def height_of_pins(self, L: float, H_body: float) -> Optional[float]:
        """The lower end of the range of feasible heights of pins that holds the one that is set, else the
        near end of the nearest range; it was tried. Membranes clear tiles under high pins; beside sharp folds
        high pins run into one another."""
        H_pin = self._parameters.get("H_pin")
        values = _about("H_pin", H_pin)

        def feasible(value: float) -> bool:
            return self(L, H_body, value).feasible

        start = _nearest(values, H_pin, feasible)
        if start is None:
            return None
        step = 1 if start < H_pin else -1
        return values[_reach(values, values.index(H_pin), values.index(start), feasible, step)]

    def thinner_with_pins(self, L: float, H_body: float, alone: Optional[float]
                          ) -> Optional[Sizes]:
        """The largest feasible thickness between `alone`, which does by itself (None: none does), and the
        one that is set, with pins lower in proportion, mm: between parts that face one another both are in
        the way. None where there is none."""
        least, H_pin = value_range("H_pin")[0], self._parameters.get("H_pin")
        low = self.thinnest if alone is None else alone
        sizes = [(thickness, max(least, math.floor(100 * H_pin * thickness / H_body) / 100))
                 for thickness in series(low, H_body) if low < thickness < H_body]
        found = _last(sizes, lambda size: self(L, *size).feasible)
        return None if found < 0 else tuple(zip(("H_body", "H_pin"), sizes[found]))


def _about(name: str, value: float) -> list[float]:
    """The series about a parameter's value, with the value itself in it."""
    low, high = value_range(name)
    values = series(max(low, value / FARTHEST), min(high, value * FARTHEST))
    return sorted([*(one for one in values if abs(one - value) > 0.01 * value), value])


def _places(values: Sequence[float], here: int) -> list[int]:
    """Where a search from place `here` looks first: every _STRIDE-th place, and both ends."""
    return sorted({0, *range(here % _STRIDE, len(values), _STRIDE), len(values) - 1})


def _nearest(values: Sequence[float], value: float, good: Callable[[float], bool]) -> Optional[float]:
    """The good one nearest to `value`, which is one of them, of those at _places; larger ones first."""
    here = values.index(value)
    places = sorted(_places(values, here), key=lambda place: (abs(place - here), -place))
    return next((values[place] for place in places if good(values[place])), None)


def _reach(values: Sequence[float], here: int, first: int, good: Callable[[float], bool], step: int) -> int:
    """How far values, of which that at place `first` is good, stay so, upwards (step 1) or downwards (-1):
    the place of the last one before a bad one at one of the _places, and of that stride the part that
    bisection finds."""
    last = first
    for place in _places(values, here)[::step]:
        if (place - first) * step <= 0:
            continue
        if not good(values[place]):
            return last + step * (1 + _last([values[k] for k in range(last + step, place, step)], good))
        last = place
    return last


def _last(values: Sequence[_Value], good: Callable[[_Value], bool]) -> int:
    """The place of the last good value, where good ones come first; -1 where there is none."""
    low, high = -1, len(values)
    while high - low > 1:
        middle = (low + high) // 2
        if good(values[middle]):
            low = middle
        else:
            high = middle
    return low


def value_range(name: str) -> tuple[float, float]:
    row = parameter(name)
    return float(row.minimum), float(row.maximum)
