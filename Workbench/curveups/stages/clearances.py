# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how near printed tiles come to one another and how much actuated tiles overlap: in closed form, so
that a verdict without solids covers it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Optional, Sequence

from ..base.errors import CurveUpsError
from ..base.findings import Finding, all_of, failed
from ..base.native import native, translated
from .stage import Inputs, Job, Result, Stage


@dataclass(frozen=True)
class Clearances(Result):
    """None where the work was stopped or the tiles can't be made (`broken` says why)."""

    flat_mm: Optional[float] = None        # least distance of two tiles; infinite with one tile
    overlap_mm3: Optional[float] = None    # largest volume that two share when actuated
    broken: tuple[Finding, ...] = ()       # reasons
    note: Optional[Finding] = None         # why this is not known

    def report(self) -> dict[str, Any]:
        if self.flat_mm is None:
            return {}
        return {"clearances": {"min_flat_mm": self.flat_mm if math.isfinite(self.flat_mm) else None,
                               "max_overlap_actuated_mm3": self.overlap_mm3}}

    def reasons(self) -> Sequence[Finding]:
        return self.broken


def _run(inputs: Inputs, job: Job) -> Clearances:
    design = inputs["design"].design.with_parameters(inputs.parameters)
    try:
        with translated(inputs.where):
            flat, overlap, reasons = native.measure_clearances(design, job)
    except CurveUpsError as error:
        # Tiles that can't be made are no input that can't be read: the verdict says it.
        return Clearances(broken=(failed("unprintable", error),))
    return Clearances(flat, overlap, all_of(reasons))


STAGE = Stage("clearances", ("design",), frozenset({"tiles", "bodies"}), _run,
              on_stop=lambda stage, inputs: Clearances(note=Finding.about("stopped", stage=stage)),
              label="Clearances", asked_by=("solve", "verify"), judges=True)
