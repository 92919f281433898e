# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a layout where the estimates of feasibility are in doubt, and of other sizes that are to be named;
repairs and verifies it. How far a membrane passes from a tile only these tell."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, unique
from .feasibility import SAG, Feasibility, Obstacle, cut_by_membranes
from .stage import Inputs, Job, Result, Stage, digest
from .trial import MOST_TILES, REPAIR_STEPS, trial

# Below this part of H_pin the clearance of membranes is in doubt: of 120 targets drawn at random none failed
# by its membranes above 0.63.
DOUBT = 0.75
# Repair of tiles that are thicker than this part of their length takes seconds a step.
STOUTEST = 1.0
# Where a trial failed, other sizes have to give membranes more room than there was, by this part of H_pin.
MORE = 0.1
# Kinds of reasons of a design that feasibility is about; all others are of contact forces and glue.
COVERED = frozenset({"not_laid_out", "gap", "pin_bounds", "pins_below_floor", "overlap", "bodies_meet",
                     "bodies_overlap", "membrane.cuts"})
# Nothing that is COVERED was in the way; something was; repair had not ended after REPAIR_STEPS, and the
# estimates stand.
PASSED, FAILED, UNDECIDED = "passed", "failed", "undecided"


@dataclass(frozen=True)
class TrialLayout(Result):
    """`blocked`: as Feasibility has it, with what was found in place of estimates."""

    blocked: tuple[Obstacle, ...]
    # PASSED, FAILED or UNDECIDED; empty: no doubt, something certain in the way, tiles too many or stout, or
    # not verified.
    shown: str = ""
    sag: float = SAG  # the part of H_pin by which membranes of other sizes are to clear tiles
    # Why the design is not valid though all tiles can be made: contact forces and glue, most often.
    beyond: tuple[Finding, ...] = ()

    @property
    def feasible(self) -> bool:
        """Whether nothing is known or expected to be in the way; contact forces are not looked at."""
        return not self.blocked

    @property
    def sizes_do(self) -> bool:
        """Whether nothing that depends on sizes is in the way: closed surfaces stay closed."""
        return all(one.obstacle == "closed" for one in self.blocked)

    @property
    def does(self) -> bool:
        """Whether sizes do, and repair had come to its end where a trial was made."""
        return self.sizes_do and self.shown != UNDECIDED

    @property
    def content(self) -> str:
        return digest(self.blocked, self.shown, self.sag, self.beyond)


def _run(inputs: Inputs, job: Job) -> TrialLayout:
    found: Feasibility = inputs["feasibility"]
    low = found.membrane_clearance < DOUBT * inputs.parameters.get("H_pin")
    return decide(inputs, found, job) if found.blocked or low.any() else TrialLayout(())


def decide(inputs: Inputs, found: Feasibility, job: Job, values: Mapping[str, Any] = MappingProxyType({}),
           steps: Optional[list[int]] = None, begun: Optional[Any] = None) -> TrialLayout:
    """What a trial layout shows with these values of parameters, of which `found` is, and what else is begun;
    estimates alone where none can be made. steps: of repair, from which those that it takes are taken off."""
    def get(name: str) -> Any:
        return values.get(name, inputs.parameters.get(name))

    if not (found.possible and get("run_verification") and len(found.F) <= MOST_TILES
            and get("H_body") <= STOUTEST * found.L):
        return TrialLayout(found.blocked)
    try:
        made = trial(inputs, values, job, steps or [REPAIR_STEPS], begun)
    except CurveUpsError as error:
        return _failed(found, get("H_pin"), [error.finding] if error.finding else [])
    if made is None:
        return TrialLayout(found.blocked, UNDECIDED)
    cuts = made["repair"].cuts
    reasons = unique([*cuts, *(reason for result in made.values() for reason in result.reasons())])
    if not cuts and not made["verification"].judged:
        return TrialLayout(found.blocked)
    if not cuts and made["verification"].failure:
        return TrialLayout(found.blocked, beyond=reasons)
    covered = [one for one in reasons if one.kind in COVERED]
    return _failed(found, get("H_pin"), covered) if covered else TrialLayout((), PASSED, beyond=reasons)


def _failed(found: Feasibility, H_pin: float, reasons: Sequence[Finding]) -> TrialLayout:
    clearance = found.membrane_clearance
    blocked = tuple(Obstacle(Finding.about(one.kind, [tile], **one.figures))
                    for one in reasons for tile in one.tiles)
    if not blocked:  # no tile is named: it is expected where membranes pass lowest
        blocked = found.blocked or tuple(cut_by_membranes(clearance, DOUBT * H_pin))
    return TrialLayout(tuple(sorted(blocked, key=lambda one: one.tile)), FAILED,
                       _more(clearance / H_pin, blocked))


def _more(clearance: np.ndarray, blocked: Sequence[Obstacle]) -> float:
    """What membranes of other sizes should clear, in parts of H_pin, after these did not do."""
    if not any(one.obstacle == "membrane" for one in blocked):
        return SAG
    return max(SAG, min(DOUBT, float(np.nanmin(clearance)) + MORE))


STAGE = Stage("trial layout", ("target", "target smoothing", "division", "feasibility"),
              frozenset({"target", "tiles", "layout", "bodies", "physics", "repair"}), _run,
              label="Trial layout", asked_by=("check",), shown=True)
