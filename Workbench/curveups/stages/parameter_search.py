# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter search for a design that is not valid. Where its sizes are in the way of its target already
(pins that meet those of another part, say), others are looked for as check does. Where membranes cut into
tiles, the design is made anew with other pins and thicknesses: how far a membrane passes from a tile only the
layout and its equilibrium tell."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence

from ..base.errors import CurveUpsError
from ..base.findings import Finding
from ..base.parameters import with_values
from .advice import Sizes, checked_sizes, tried_sizes
from .feasibility import sizes_do
from .size_search import value_range
from .sizes import sizes_that_do
from .stage import Inputs, Job, Result, Row, Stage
from .trial import MOST_TILES, REPAIR_STEPS, trial

# What is tried, as factors of what is set.
_TRIED: tuple[dict[str, float], ...] = ({"H_pin": 1.25}, {"H_pin": 1.5}, {"H_body": 0.5},
                                        {"H_body": 0.4, "H_pin": 1.25})


@dataclass(frozen=True)
class OtherSizes(Result):
    """What does instead of the values that are set (names, mm); None: nothing of what was tried. checked:
    with which nothing is in the way of the target."""

    found: Optional[Sizes] = None
    tried: int = 0
    was_stopped: bool = False
    checked: Sequence[Sizes] = ()

    def advice(self) -> Sequence[Finding]:
        return (*checked_sizes(self.checked), *tried_sizes(self.found, self.tried))

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("trials", seconds, self.tried),) if self.tried or self.checked else ()


def _run(inputs: Inputs, job: Job) -> OtherSizes:
    verification = inputs["verification"]
    if not verification.judged or verification.failure:
        return OtherSizes()
    if verification.valid and not inputs["clearances"].broken:
        return OtherSizes()
    unmended = with_values(inputs.parameters, {"mend": "off"})
    if not sizes_do(inputs["target smoothing"].V, inputs["target"].F, inputs["cuts"].edges, unmended, job):
        return OtherSizes(checked=tuple(sizes_that_do(inputs, inputs["cut request"], job)[0]))
    cut = verification.blocks["physics"]["membrane_clearance_mm"] < 0
    # It takes a while: only for those who want their target made possible.
    if not cut or inputs.parameters.get("mend") != "on" or len(inputs["target"].F) > MOST_TILES:
        return OtherSizes()
    return other_sizes(inputs, job)


def other_sizes(inputs: Inputs, job: Job) -> OtherSizes:
    """Higher pins and thinner tiles one after another, until the target becomes a valid design with one of
    them. Where REPAIR_STEPS are used up, those that are left have to do without repair."""
    tried, steps = 0, [REPAIR_STEPS]
    for factors in _TRIED:
        sizes = tuple((name, float(f"{factor * inputs.parameters.get(name):.2g}"))
                      for name, factor in factors.items())
        if all(value_range(name)[0] <= value <= value_range(name)[1] for name, value in sizes):
            tried += 1
            if _valid(inputs, sizes, job, steps):
                return OtherSizes(sizes, tried)
    return OtherSizes(None, tried)


def _valid(inputs: Inputs, sizes: Sizes, job: Job, steps: list[int]) -> bool:
    """Whether a copy of the project says so before repair has taken the steps that are left."""
    job.go_on("trying " + ", ".join(f"{name} = {value:g} mm" for name, value in sizes))
    try:
        found = trial(inputs, dict(sizes), job, steps)
    except CurveUpsError:
        return False
    return bool(found and found["layout"].converged and not found["repair"].cuts
                and found["verification"].valid)


STAGE = Stage("trials", ("target", "target smoothing", "cut request", "cuts", "verification", "clearances"),
              frozenset({"target", "tiles", "layout", "bodies", "physics", "repair"}), _run,
              lambda error, inputs: OtherSizes(), lambda stage, inputs: OtherSizes(was_stopped=True),
              label="Other sizes", asked_by=("solve",))
