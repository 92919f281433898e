# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chooses sizes of tiles by solving: the largest first, until a design is valid."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Callable, Collection, Mapping, Optional

from ..base.errors import CurveUpsError, Stopped
from ..base.findings import Finding, failed
from ..base.parameters import with_values
from ..stages.sizes import LEAST_TILES, can_remesh, length_of, rounded, unhindered, value_range
from ..stages.stage import Job
from .project import Project

_SENTENCES = {"L": "size.L", "H_body": "size.H_body"}
AUTOMATIC = tuple(_SENTENCES)  # parameters that may be "auto"
MOST_TILES = 5000  # bounds the shortest length
MOST_TRIED = 6     # lengths, and thicknesses
SHORTER = 0.85     # the next length
# Thicknesses in parts of L; the paper has 3/7.
THICKNESSES = (6 / 14, 5 / 14, 4 / 14, 3 / 14, 2 / 14, 1 / 14)
GOALS = ("clearances", "verification", "pieces")


@dataclass(frozen=True)
class SizeChoice:
    """project: with the chosen values and their results. tried: findings of all values tried, in order.
    Chosen are the last values where their design is valid, else the first ones with a design."""

    project: Project
    values: Mapping[str, float]
    valid: bool
    tried: tuple[Finding, ...] = ()

    def findings(self) -> list[Finding]:
        """Warnings that list the sizes tried, and say where none is valid."""
        return [*self.tried, *(() if self.valid else (Finding("tried.none"),))]


def choose(project: Project, names: Collection[str], job: Job) -> SizeChoice:
    """Solves for a short list of values of the named parameters (of AUTOMATIC) until a design is valid:
    lengths at which tiles stay within `maximum_deviation` of the surface, from the largest on, and
    THICKNESSES. With both, the thicknesses of the first length at which thin tiles can be made. Values whose
    margins block tiles are not solved. Raises CurveUpsError where no value gives a design, and Stopped."""
    results = project.run(("target",), job)
    target = results["target"]
    search = _Search(project, job)
    if "L" not in names:
        search.thickness(results.parameters.get("L"), {})
    elif not can_remesh(target, project.latest("cut request")):
        raise CurveUpsError("L can't be auto where the mesh is given", project.where,
                            "give cuts as polylines, or L as a number")
    elif "H_body" not in names:
        search.length(target, lambda L: search.solve({"L": L}))
    else:
        L = search.length(target, lambda L: search.clear({"L": L, "H_body": rounded(THICKNESSES[-2] * L)})
                          is not None)
        if L is not None:
            search.thickness(L, {"L": L})
    if search.chosen is None:
        tried = "; ".join(map(str, filter(None, (*search.tried, search.sharpest))))
        raise CurveUpsError(f"no size was found that works: {tried}", project.where,
                            "raise maximum_deviation, or see 'curveups check'")
    return replace(search.chosen, tried=tuple(search.tried))


def _named(values: Mapping[str, float]) -> tuple[Finding, ...]:
    return tuple(Finding.about(_SENTENCES[name], value=value) for name, value in values.items())


class _Search:
    def __init__(self, project: Project, job: Job):
        self._project, self._job = project, job
        self.tried: list[Finding] = []
        self.chosen: Optional[SizeChoice] = None  # a valid one, or the first with a design
        self.sharpest: Optional[Finding] = None   # fold, at the first sizes that one blocks

    def thickness(self, L: float, values: Mapping[str, float]) -> None:
        """Solves for the thicknesses of this length until a design is valid. values: other parameters."""
        least, most = value_range("H_body")
        for part in THICKNESSES:
            H_body = rounded(part * L)
            if least <= H_body <= most and self.solve({**values, "H_body": H_body}):
                return

    def length(self, target: Any, works: Callable[[float], bool]) -> Optional[float]:
        """First length, from the largest on, that keeps tiles near the surface and works."""
        most_far = self._project.parameters.get("maximum_deviation")
        least, most = value_range("L")
        L = min(most, length_of(LEAST_TILES, target))
        if target.chord_error > 0:  # it grows with the square of the length
            L = min(L, self._project.parameters.get("L") * math.sqrt(most_far / target.chord_error))
        least = rounded(max(least, length_of(MOST_TILES, target)))
        for _ in range(MOST_TRIED):
            L = max(rounded(L), least)
            error, shorter = self._chord_error(L), SHORTER
            if error > most_far:
                self._refuse({"L": L}, Finding.about("tried.far", distance=error))
                shorter = max(0.5, min(SHORTER, math.sqrt(most_far / error)))
            elif works(L):
                return L
            if L == least:
                break
            L *= shorter
        return None

    def _chord_error(self, L: float) -> float:
        """Largest distance of the surface from its tiles, mm; infinite where it can't be remeshed."""
        try:
            return float(self._with({"L": L}).run(("target",), self._job)["target"].chord_error)
        except CurveUpsError:
            return math.inf

    def _refuse(self, values: Mapping[str, float], *why: Finding) -> None:
        self.tried.append(Finding.about("tried.not_valid", sizes=_named(values), why=why))

    def _with(self, values: Mapping[str, float]) -> Project:
        named = ", ".join(f"{name} = {value:g} mm" for name, value in values.items())
        self._job.go_on(f"trying {named}")
        twin = self._project.copy()
        twin.parameters = with_values(twin.parameters, values)
        return twin

    def clear(self, values: Mapping[str, float]) -> Optional[Project]:
        """Project with these values; None, with an entry in `tried`, where margins block tiles."""
        try:
            twin = self._with(values)
            feasibility = twin.run(("feasibility",), self._job)["feasibility"]
        except CurveUpsError as error:
            self._refuse(values, failed("tried.error", error))
            return None
        if unhindered(feasibility):
            return twin
        tiles = {obstacle.tile for obstacle in feasibility.blocked}
        self.sharpest = self.sharpest or feasibility.sharpest
        self._refuse(values, Finding.about("tried.blocked", tiles, count=len(tiles), of=len(feasibility.F)))
        return None

    def solve(self, values: Mapping[str, float]) -> bool:
        """Makes and verifies a design with these values, and with suggested cuts, if requested, where the
        surface is closed. Returns whether it is valid, or not known to be invalid without verification."""
        twin = self.clear(values)
        if twin is None:
            return False
        try:
            request, blocked = twin.latest("cut request"), twin.latest("feasibility").blocked
            if request.suggested and any(obstacle.obstacle == "closed" for obstacle in blocked):
                twin.give("cut request", request.accept(twin.run(("cut search",), self._job)["cut search"]))
            results = twin.run(GOALS, Job(self._job))  # without listener of iterates
        except CurveUpsError as error:
            self._refuse(values, failed("tried.error", error))
            return False
        if results.stopped:
            raise Stopped
        valid = results.verdict.valid is not False
        if valid:
            self.tried.append(Finding.about("tried.valid", sizes=_named(values)))
        else:
            self._refuse(values, *results.verdict.reasons[:1])
        if valid or self.chosen is None:
            self.chosen = SizeChoice(twin, values, valid)
        return valid
