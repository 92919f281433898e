# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets the tiles of the finished design settle under their membranes, with friction: whether the shape holds,
how far membranes and friction may be off until it does not, and the shape that the piece has then."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Mapping, Optional, Sequence

import numpy as np

from ..base.errors import CurveUpsError
from ..base.findings import Finding, Value, failed
from ..base.native import native, translated
from .stage import Inputs, Job, Picture, Result, Row, Stage


@dataclass(frozen=True)
class Range(Value):
    """The values of a parameter, all others as they are, at which the shape holds; None at an end where
    nothing fails in what was searched. `failures`: what fails first beyond either end."""

    parameter: str
    unit: str
    searched: tuple[float, float]
    ends: tuple[Optional[float], Optional[float]]
    failures: tuple[Optional[Finding], Optional[Finding]]

    def report(self) -> dict[str, Any]:
        (low, high), (fails_low, fails_high) = self.ends, self.failures
        return {"parameter": self.parameter, "unit": self.unit, "searched": list(self.searched),
                "low": low, "high": high,
                "fails_low": fails_low and fails_low.entry(), "fails_high": fails_high and fails_high.entry()}


@dataclass(frozen=True)
class Settled(Result):
    """`holds` is None where that was not asked for, could not be found out or was stopped. `note`: why the
    verdict has to stay open, where the margin is required."""

    holds: Optional[bool] = None
    block: Mapping[str, Any] = field(default_factory=dict)  # as report.json has it
    failure: Optional[Finding] = None  # why it does not hold, or why that is not known though it was wanted
    margin: Mapping[str, Any] = field(default_factory=dict)
    friction_needed: Mapping[str, Any] = field(default_factory=dict)
    beyond: tuple[Finding, ...] = ()   # why the margin is not met
    window: tuple[Range, ...] = ()
    note: Optional[Finding] = None
    iterations: int = 0
    design: Any = None                 # native Design, for the picture
    deviation: Any = ()                # per tile, mm
    contact_force: Any = ()            # per contact, normal, N

    def report(self) -> dict[str, Any]:
        window = {"window": [one.report() for one in self.window]} if self.window else {}
        blocks = {"settled": self.block, "margin": self.margin, "friction_needed": self.friction_needed}
        return {"holds": self.holds, **(blocks if self.block else {}), **window}

    def reasons(self) -> Sequence[Finding]:
        return self.beyond if self._required else ()

    def warnings(self) -> Sequence[Finding]:
        failure = (self.failure,) if self.failure else ()
        return failure if self._required else (*failure, *self.beyond)

    @property
    def _required(self) -> bool:
        return self.margin.get("mode") == "require"

    def rows(self, seconds: float) -> Sequence[Row]:
        return (Row("settle", seconds, self.iterations),) if self.block else ()

    def pictures(self) -> Sequence[Picture]:
        if not self.block:
            return ()
        marked = [tuple(pair) for pair in self.block["open_contacts"]]
        return (Picture("Settled shape", "Virtual scan: mean distance of each tile from the design's surface "
                        "once the tiles have settled." + (" Open contacts are marked." if marked else ""),
                        "flat",
                        {"design": self.design, "values": self.deviation, "label": "mm", "marked": marked}),)


def _run(inputs: Inputs, job: Job) -> Settled:
    values = inputs.parameters
    if not values.get("run_settling") or not inputs["verification"].blocks:
        return Settled(note=_open(inputs, Finding("unsettled_design")))
    try:
        design = inputs["design"].design.with_parameters(values)
        with translated(inputs.where):
            found = native.settle_design(design, job, inputs["verification"].solved)
    except CurveUpsError as error:  # however strict the run is: the verdict is known without
        return _failed(error, inputs)
    margin, failure = found.margin, _finding(found.failure)
    beyond = [Finding.of(one) for one in margin.failures if one and one.kind != "margin.unknown"]
    block = {"mode": margin.mode, "mismatch_percent": margin.mismatch,
             "friction_coefficient": margin.friction_coefficient, "met": margin.met}
    needed = {"coefficient": found.friction_needed.coefficient, "tiles": list(found.friction_needed.tiles)}
    return Settled(found.holds, found.block, failure, block, needed, tuple(beyond),
                   tuple(map(_range, found.window)),
                   _open(inputs, Finding("margin.unknown")) if margin.met is None else None,
                   found.iterations, design, np.asarray(found.deviation), np.asarray(found.contact_force))


def _range(found: Any) -> Range:
    low, high = found.low, found.high
    return Range(found.parameter, found.unit, (found.searched[0], found.searched[1]),
                 (low.value if low.failure else None, high.value if high.failure else None),
                 (_finding(low.failure), _finding(high.failure)))


def _finding(found: Any) -> Optional[Finding]:
    return Finding.of(found) if found else None


def _open(inputs: Inputs, why: Finding) -> Optional[Finding]:
    return why if inputs.parameters.get("margin") == "require" else None


def _failed(error: CurveUpsError, inputs: Inputs) -> Settled:
    failure = failed("settle_failed", error)
    return Settled(failure=failure, note=_open(inputs, failure))


PARTS = frozenset({"tiles", "bodies", "physics", "settle"})
STAGE = Stage("settle", ("design", "verification"), PARTS, _run, _failed,
              lambda stage, inputs: Settled(note=_open(inputs, Finding.about("stopped", stage=stage))),
              label="Settled forces", asked_by=("settle", "verify"),
              judges=lambda values: values.get("margin") == "require")
