# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter search: makes a design whose membranes cut into tiles anew with other pins and thicknesses. How
far a membrane passes from a tile only the layout and its equilibrium tell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError, Stopped
from ..base.native import native, translated
from .fairing import fair
from .relief import make_room
from .sizes import MOST_TILES, value_range
from .stage import Inputs, Job, Result, Row, Stage
from .verification import verify

# What is tried, as factors of what is set: each takes as long as the design itself.
_TRIED: tuple[dict[str, float], ...] = ({"H_pin": 1.25}, {"H_pin": 1.5}, {"H_body": 0.5},
                                        {"H_body": 0.4, "H_pin": 1.25})
Sizes = tuple[tuple[str, float], ...]


@dataclass(frozen=True)
class OtherSizes(Result):
    """What does instead of the values that are set (names, mm); None: nothing of what was tried."""

    found: Optional[Sizes] = None
    tried: int = 0
    was_stopped: bool = False

    @property
    def stopped(self) -> bool:
        return self.was_stopped

    def advice(self) -> Sequence[str]:
        if self.found is None:
            return [f"no other H_pin or H_body does, of {self.tried} that were tried"] if self.tried else []
        sizes = " ".join(f"{name}={value:g}" for name, value in self.found)
        return [f"suggested: {sizes}, with which it is valid: that was tried"]

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("trials", seconds, self.tried),) if self.tried else ()


def _run(inputs: Inputs, job: Job) -> OtherSizes:
    verification = inputs["verification"]
    if verification.valid or not verification.judged or verification.failure:
        return OtherSizes()
    cut = verification.blocks["physics"]["membrane_clearance_mm"] < 0
    # It takes a while: only for those who want their target made possible.
    if not cut or inputs.parameters.get("mend") != "on" or len(inputs["target"].F) > MOST_TILES:
        return OtherSizes()
    return other_sizes(inputs, inputs["cuts"].edges, job)


def other_sizes(inputs: Inputs, edges: np.ndarray, job: Job) -> OtherSizes:
    """Higher pins and thinner tiles one after another, until the target, cut along `edges`, becomes a valid
    design with one of them."""
    tried = 0
    for factors in _TRIED:
        sizes = tuple((name, float(f"{factor * inputs.parameters.get(name):.2g}"))
                      for name, factor in factors.items())
        if all(value_range(name)[0] <= value <= value_range(name)[1] for name, value in sizes):
            tried += 1
            if _valid(inputs, edges, sizes, job):
                return OtherSizes(sizes, tried)
    return OtherSizes(None, tried)


def _valid(inputs: Inputs, edges: np.ndarray, sizes: Sizes, job: Job) -> bool:
    if not job("trying " + ", ".join(f"{name} = {value:g} mm" for name, value in sizes)):
        raise Stopped
    target, parameters = inputs["target"], native.Parameters(inputs.parameters)
    for name, value in sizes:
        parameters.set(name, value)
    try:
        with translated():
            F = target.F
            faired = np.ascontiguousarray(fair(target.V, F, parameters, job).V)
            V, moved = make_room(faired, F, edges, parameters, job)
            found, store = native.solve_layout(V, F, edges, parameters, job), native.SolutionStore()
            design = native.Design("trial", parameters, V, F, found.T, found.q, edges,
                                   (faired, F) if moved else None)
            valid = found.converged and verify(design, job, store).valid
            if found.converged and not valid and parameters.get("repair"):
                valid = verify(native.repair_design(design, store, job).design, job).valid
    except CurveUpsError:
        valid = False
    if job.stopped:
        raise Stopped
    return bool(valid)


STAGE = Stage("trials", ("target", "cuts", "verification"),
              frozenset({"target", "tiles", "layout", "bodies", "physics", "repair"}), _run,
              lambda error, inputs: OtherSizes(), lambda stage, inputs: OtherSizes(was_stopped=True),
              label="Other sizes", asked_by=("solve",))
