# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lays a target out as a design of it would be, for what closed forms can only estimate: how far membranes
stay from tiles depends on where the layout puts the pins, and on what repair does about it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from ..base.errors import Stopped
from ..base.findings import Finding, all_of
from ..base.native import native
from .stage import Job

MOST_TILES = 3000  # more take longer to be laid out than users wait for a check
# Steps of repair: it draws pins away from where membranes cut in few steps, or not at all. Fewer where they
# take longer: so many times the tiles in all.
_STEPS, TILES_OF_STEPS = 24, 12000


@dataclass(frozen=True)
class TrialLayout:
    """`clearance`: M x 2, mm, of the membranes over each tile, front and back; NaN: there is no layout.
    `broken`: why there is none, or which constraints it breaks. `ended`: no more steps of repair were left
    to be taken."""

    clearance: np.ndarray
    broken: tuple[Finding, ...] = ()
    ended: bool = True

    def clears(self, least: float) -> bool:
        """Whether membranes stay so far (mm) from all tiles, and nothing is broken."""
        return not self.broken and bool((self.clearance >= least).all())


def lay_out(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job,
            tiles_of_steps: int = TILES_OF_STEPS, of_membranes: bool = False) -> Optional[TrialLayout]:
    """Of a mesh on which pins have made room for themselves, repaired where the design would be, by so many
    steps times tiles. `of_membranes`: only while no contact is weak, since a step of that takes seconds on
    some targets. None where there are more than MOST_TILES, or no flat map. Raises Stopped, and what
    the module raises but for the reasons of a TrialLayout."""
    maps = native.target_fields(V, F, edges, parameters)
    if len(F) > MOST_TILES or np.isnan(maps["conformal_stretch"]).any():
        return None
    repairs = parameters.get("run_verification") and parameters.get("run_repair")
    steps = min(_STEPS, tiles_of_steps // len(F)) if repairs else 0
    try:
        return _lay_out(V, F, edges, parameters, job, steps, of_membranes)
    except (native.InfeasibleDesign, native.SolverFailure) as error:
        return TrialLayout(np.full((len(F), 2), np.nan),
                           (Finding.about("not_laid_out", error.tiles, said=str(error)),))


def _lay_out(V: np.ndarray, F: np.ndarray, edges: np.ndarray, parameters: Any, job: Job,
             steps: int, of_membranes: bool) -> TrialLayout:
    found = native.solve_layout(V, F, edges, parameters, job)
    if found.stopped:
        raise Stopped
    design, store = native.Design("", parameters, V, F, found.T, found.q, edges), native.SolutionStore()
    clearance, broken = _measure(design, store, job)
    ended = True
    if steps and (broken or clearance.min(initial=0) < 0):
        design, ended = _repair(design, store, steps, of_membranes, job)
        clearance, broken = _measure(design, store, job)
    return TrialLayout(clearance, broken, ended)


def _measure(design: Any, store: Any, job: Job) -> tuple[np.ndarray, tuple[Finding, ...]]:
    clearance = np.asarray(native.membrane_clearances(design, store, job))
    return clearance, all_of(native.evaluate_design(design).reasons)


def _repair(design: Any, store: Any, steps: int, of_membranes: bool, job: Job) -> tuple[Any, bool]:
    """What repair makes of it, and whether it came to an end: itself where it can't begin, as a design ends
    then."""
    left = steps

    def go_on(T: object, q: object, weak: float, violation: float = 0) -> bool:
        nonlocal left
        left -= 1
        return left >= 0 and not (of_membranes and weak)

    try:
        found = native.repair_design(design, store, job, go_on)
    except (native.InfeasibleDesign, native.SolverFailure):
        return design, True
    if job.stopped:
        raise Stopped
    return found.design, found.status != "stopped"
