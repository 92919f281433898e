# SPDX-License-Identifier: LGPL-2.1-or-later
"""Searches for sizes of tiles that work for a target, by trying them: the surface is remeshed at other L and
given other thicknesses and pins, and examined as a design would be (feasibility.py). What is named was laid
out, too (trial_layout.py)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Callable, Optional, Sequence, TypeVar

import numpy as np

from ..base.parameters import parameter
from ..base.errors import CurveUpsError, Stopped
from ..base.native import native, translated
from .cut_request import CutRequest
from .division import all_cuts
from .feasibility import SAG, sizes_do, with_room
from .pin_smoothing import short_sides, smooth_for_pins
from .stage import Job
from .target import remesh
from .trial_layout import lay_out

# Lengths and heights of pins are tried up to this factor from the one that is set, lengths as long as that
# makes no more tiles than these or than there are, and thicknesses up to so many lengths.
FARTHEST, MOST_TILES, LEAST_TILES, THICKEST = 2.5, 1000, 12, 2.0
MOST_CHOSEN = 5000  # tiles, as long as there are no more of which a length is chosen
_Value = TypeVar("_Value")
_STRIDE = 6  # values of the series from one trial to the next, before the ends are narrowed down
# Layouts that fail before nothing is named, and the tiles of all of them: some 2 ms each.
_MOST_DENIED, _MOST_LAID_OUT = 3, 4000
_REPAIRED = 2000  # steps of repair times tiles, of each: some 2 s
# Where more pin sides are short, making room for them takes ten seconds: it is left out, and membranes have
# to stay as far from tiles as estimates ask for.
_MOST_MOVED = 100


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


class ParameterSearch:
    """Sizes on one surface (V, F, creases: what is remeshed). What can't be remeshed or has no tiles is not
    feasible; only stopping ends the search."""

    def __init__(self, V: np.ndarray, F: np.ndarray, cuts: CutRequest, parameters: Any, job: Job,
                 creases: Optional[np.ndarray] = None):
        self._surface, self._creases, self._cuts = (V, F), creases, cuts
        self._outer, self._job, self._trying = job, Job(self._tell), ""
        self._parameters = parameters
        self.thinnest = max(value_range("H_body")[0], parameters.get("p_floor"))  # that a printer makes
        self.made: dict[tuple[float, float, float], Candidate] = {}
        self.decided: set[tuple[float, float, float]] = set()  # those that were laid out
        self._left = _MOST_LAID_OUT
        self._chord_errors: dict[float, float] = {}
        corners = V[F]
        self._area = float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                                   corners[:, 2] - corners[:, 0]), axis=1).sum() / 2)
        self._mesh = lru_cache(maxsize=1)(self._remesh)  # thicknesses are tried on one mesh

    def tiles(self, L: float) -> float:
        """About how many tiles of this length there would be."""
        return self._area / (math.sqrt(3) / 4 * L * L)

    def start_from(self, L: float, made: Any) -> None:
        """What there is already at this length: V, F, chord error."""
        self._mesh = lru_cache(maxsize=1)(
            lambda asked: (made.V, made.F, made.chord_error) if asked == L else self._remesh(asked))

    def __call__(self, L: float, H_body: float, H_pin: Optional[float] = None) -> Candidate:
        """H_pin: else as it is set."""
        key = L, H_body, float(self._parameters.get("H_pin") if H_pin is None else H_pin)
        if key not in self.made:
            self._say("trying L = {:g} mm, H_body = {:g} mm, H_pin = {:g} mm".format(*key))
            self.made[key] = self._try(*key)
        return self.made[key]

    def holds(self, L: float, H_body: float, H_pin: Optional[float] = None) -> bool:
        """Whether a layout, where one is made (trial_layout.py), says so, too. What it denies is not feasible
        from then on. After _MOST_LAID_OUT tiles nothing holds but what is known to."""
        one = self(L, H_body, H_pin)
        key = L, H_body, one.H_pin
        if not one.feasible or key in self.decided:
            return one.feasible
        if one.tiles > self._left:
            return False
        self._say("laying out L = {:g} mm, H_body = {:g} mm, H_pin = {:g} mm".format(*key))
        self._left -= one.tiles
        self.decided.add(key)
        self.made[key] = replace(one, feasible=self._lay_out(*key))
        return self.made[key].feasible

    def first_that_holds(self, values: Sequence[_Value], sizes: Callable[[_Value], tuple[float, ...]]
                         ) -> Optional[_Value]:
        """Of values from the one to be named to the one that is surest: the first of three that holds."""
        few = [*values[:-1:_STRIDE][:2], *values[-1:]]
        return next((value for value in few if self.holds(*sizes(value))), None)

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

    def _values(self, L: float, H_body: float, H_pin: float) -> Any:
        values = native.Parameters(self._parameters)
        for name, value in (("L", L), ("H_body", H_body), ("H_pin", H_pin)):
            values.set(name, value)
        return values

    def _lay_out(self, L: float, H_body: float, H_pin: float) -> bool:
        values, least = self._values(L, H_body, H_pin), 0.0
        try:
            with translated():
                V, F, _ = self._mesh(L)
                edges = all_cuts(self._cuts, V, F, values, self._job)
                there = with_room(V, F, edges, values, self._job)
                if there is V and short_sides(V, F, edges, values) <= _MOST_MOVED:
                    there, _ = smooth_for_pins(V, F, edges, values, self._job)
                elif there is V:
                    least = SAG * H_pin
                made = None if there is None else lay_out(there, F, edges, values, self._job, _REPAIRED, True)
        except CurveUpsError:
            return False
        return there is not None and (made is None or made.clears(least))

    def _try(self, L: float, H_body: float, H_pin: float) -> Candidate:
        values = self._values(L, H_body, H_pin)
        tiles = 0
        try:
            with translated():
                V, F, _ = self._mesh(L)
                tiles = len(F)
                edges = all_cuts(self._cuts, V, F, values, self._job)
                feasible = sizes_do(V, F, edges, values, self._job)
        except CurveUpsError:
            feasible = False
        return Candidate(L, H_body, H_pin, tiles, feasible)

    def _remesh(self, L: float) -> tuple[np.ndarray, np.ndarray, float]:
        made = remesh(*self._surface, L, self._parameters, self._job, self._creases)
        return made.V, made.F, float(made.chord_error)

    def largest_thickness(self, L: float, most: float) -> Optional[float]:
        """The largest feasible thickness of a series from `thinnest` to `most`, found by bisection; None
        where the least has no tiles either."""
        return next(iter(self._thicknesses(L, most)), None)

    def thickness_that_holds(self, L: float, most: float, least: float = 0.0) -> Optional[float]:
        """As largest_thickness, but laid out; `least`: one that holds, where one is known."""
        values = [value for value in self._thicknesses(L, most) if value > least]
        return self.first_that_holds([*values, *([least] if least else [])], lambda value: (L, value))

    def _thicknesses(self, L: float, most: float) -> list[float]:
        """Of the series, from the largest feasible one down."""
        values = series(self.thinnest, most)
        return values[:_last(values, lambda H_body: self(L, H_body).feasible) + 1][::-1]

    def largest_length(self, L: float, thickness: Callable[[float], float], maximum_deviation: float,
                       where: str) -> float:
        """The largest feasible length that was tried at which the surface stays within `maximum_deviation`
        (mm) of its facets; L: one that was tried. Raises CurveUpsError where there is none."""
        low, high = value_range("L")
        values = [value for value in series(low, high) if LEAST_TILES <= self.tiles(value) <= MOST_CHOSEN]
        if not values:
            raise CurveUpsError("the surface is too large or too small for tiles", where,
                                "check its unit (scale, fit)")

        def near(value: float) -> bool:
            return self.chord_error(value) <= maximum_deviation

        # It grows with the square of the length, as long as that is small against the curvature's radius.
        chord_error = self.chord_error(L)
        guess = L * math.sqrt(maximum_deviation / chord_error) if chord_error > 0 else values[-1]
        place = int(np.argmin(np.abs(np.log(np.array(values) / guess))))
        while place > 0 and not near(values[place]):
            place = max(0, place - _STRIDE // 2)
        last = place + _reach(values[place:], near) if near(values[place]) else -1
        for place in range(last, -1, -1):
            if near(values[place]) and self(values[place], thickness(values[place])).feasible:
                return values[place]
        raise CurveUpsError(f"no L does that keeps tiles within {maximum_deviation:g} mm of the surface",
                            where, "raise maximum_deviation, or see 'curveups check'")

    def lengths(self, L: float) -> list[float]:
        """The series of lengths about L, with L itself in it."""
        most = max(MOST_TILES, self.tiles(L))
        return [value for value in _about("L", L) if value == L or LEAST_TILES <= self.tiles(value) <= most]

    def nearest_length(self, L: float, H_body: float) -> Optional[float]:
        """The length nearest to L that holds, of those tried, with every _STRIDE-th of the series."""
        # Fewer tiles first: that is quicker.
        return _nearest(self.lengths(L), L, lambda value: self(value, H_body).feasible,
                        lambda value: self.holds(value, H_body))

    def range_of_lengths(self, L: float, H_body: float) -> Optional[tuple[float, float]]:
        """Ends of the range of feasible lengths that holds L, or of the nearest one; both hold."""
        start, values = self.nearest_length(L, H_body), self.lengths(L)
        if start is None:
            return None
        first = values.index(start)

        def feasible(value: float) -> bool:
            return self(value, H_body).feasible

        def end(ahead: list[float]) -> Optional[float]:
            return self.first_that_holds(ahead[_reach(ahead, feasible)::-1], lambda value: (value, H_body))

        return end(values[first::-1]) or start, end(values[first:]) or start

    def least_pin(self, L: float, H_body: float) -> Optional[float]:
        """The lower end of the range of feasible heights of pins that has the one that is set, or of the
        nearest one; it holds. Membranes clear tiles under high pins; beside sharp folds high pins run
        into one another."""
        H_pin = self._parameters.get("H_pin")
        values = _about("H_pin", H_pin)

        def feasible(value: float) -> bool:
            return self(L, H_body, value).feasible

        def holds(value: float) -> bool:
            return self.holds(L, H_body, value)

        start = _nearest(values, H_pin, feasible, holds)
        if start is None:
            return None
        down = values[values.index(start)::-1]
        return self.first_that_holds(down[_reach(down, feasible)::-1], lambda value: (L, H_body, value))

    def thinner_with_pins(self, L: float, H_body: float, alone: Optional[float]
                          ) -> Optional[tuple[float, float]]:
        """The largest feasible thickness between `alone`, which does by itself (None: none does), and the
        one that is set, with pins lower in proportion, mm: between parts that face one another both are in
        the way. None where there is none."""
        least, H_pin = value_range("H_pin")[0], self._parameters.get("H_pin")
        low = self.thinnest if alone is None else alone
        sizes = [(thickness, max(least, math.floor(100 * H_pin * thickness / H_body) / 100))
                 for thickness in series(low, H_body) if low < thickness < H_body]
        found = _last(sizes, lambda size: self(L, *size).feasible)
        return self.first_that_holds(sizes[:found + 1][::-1], lambda size: (L, *size))


def _about(name: str, value: float) -> list[float]:
    """The series about a parameter's value, with the value itself in it."""
    low, high = value_range(name)
    values = series(max(low, value / FARTHEST), min(high, value * FARTHEST))
    return sorted([*(one for one in values if abs(one - value) > 0.01 * value), value])


def _nearest(values: Sequence[float], value: float, good: Callable[[float], bool],
             holds: Callable[[float], bool]) -> Optional[float]:
    """The one that holds nearest to `value`, which is one of them, of every _STRIDE-th good one; larger ones
    first. Of no more than _MOST_DENIED it is asked whether they hold."""
    here, denied = values.index(value), 0
    for away in range(0, len(values), _STRIDE):
        for place in (here + away, here - away):
            if 0 <= place < len(values) and denied < _MOST_DENIED and good(values[place]):
                if holds(values[place]):
                    return values[place]
                denied += 1
    return None


def _reach(values: Sequence[float], good: Callable[[float], bool]) -> int:
    """How far values, of which the first is good, stay so: the place of the last one before a stride that
    ends in a bad one, and of that stride the part that bisection finds."""
    place = 0
    while place + 1 < len(values):
        ahead = min(place + _STRIDE, len(values) - 1)
        if not good(values[ahead]):
            return place + 1 + _last(values[place + 1:ahead], good)
        place = ahead
    return place


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
