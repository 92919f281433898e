# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds where the tiles of the finished design settle under their membranes, with friction: whether the shape
holds, by how much membranes and friction may differ until it does not, and the settled shape."""

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
    """Values of one parameter at which the shape holds; None at an end without a failure within `searched`.
    failures: first failure beyond either end."""

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
    """holds: None where it is not known. note: why the verdict stays open, where the margin is required."""

    holds: Optional[bool] = None
    block: Mapping[str, Any] = field(default_factory=dict)  # of report.json
    failure: Optional[Finding] = None  # why it does not hold, or why that is not known
    margin: Mapping[str, Any] = field(default_factory=dict)
    friction_needed: Mapping[str, Any] = field(default_factory=dict)
    beyond: tuple[Finding, ...] = ()   # why the margin is not met
    window: tuple[Range, ...] = ()
    note: Optional[Finding] = None
    iterations: int = 0
    design: Any = None                 # native Design, for the picture
    deviation: Any = ()                # per tile, mm

    def report(self) -> dict[str, Any]:
        window = {"window": [row.report() for row in self.window]} if self.window else {}
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
                        "pictures.flat_layout",
                        {"design": self.design, "values": self.deviation, "label": "mm", "marked": marked}),)


def _run(inputs: Inputs, job: Job) -> Settled:
    values = inputs.parameters
    if not values.get("run_settling") or not inputs["verification"].blocks:
        return Settled(note=_open(inputs, Finding("unsettled_design")))
    try:
        design = inputs["design"].design.with_parameters(values)
        with translated(inputs.where):
            settled = native.settle_design(design, job, inputs["verification"].solved)
    except CurveUpsError as error:  # in a strict run too: the verdict is known without
        return _failed(error, inputs)
    margin, failure = settled.margin, _finding(settled.failure)
    beyond = [Finding.of(corner) for corner in margin.failures if corner and corner.kind != "margin.unknown"]
    return Settled(settled.holds, settled.block, failure, margin.block, settled.friction_needed.block,
                   tuple(beyond), tuple(map(_range, settled.window)),
                   _open(inputs, Finding("margin.unknown")) if margin.met is None else None,
                   settled.iterations, design, np.asarray(settled.deviation))


def _range(window: Any) -> Range:
    low, high = window.ends
    return Range(window.parameter, window.unit, (window.searched[0], window.searched[1]),
                 (low.value if low.failure else None, high.value if high.failure else None),
                 (_finding(low.failure), _finding(high.failure)))


def _finding(failure: Any) -> Optional[Finding]:
    return Finding.of(failure) if failure else None


def _open(inputs: Inputs, why: Finding) -> Optional[Finding]:
    return why if inputs.parameters.get("margin") == "require" else None


def _failed(error: CurveUpsError, inputs: Inputs) -> Settled:
    failure = failed("settle_failed", error)
    return Settled(failure=failure, note=_open(inputs, failure))


PARTS = frozenset({"tiles", "bodies", "physics", "settle"})
STAGE = Stage("settle", ("design", "verification"), PARTS, _run, _failed,
              lambda stage, inputs: Settled(note=_open(inputs, Finding.about("stopped", stage=stage))),
              label="Settled forces", commands=("settle", "verify"),
              judges=lambda values: values.get("margin") == "require")
