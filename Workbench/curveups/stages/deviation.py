# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how far the actuated surface is from the target as the user gave it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

from ..base.native import native
from .stage import Inputs, Job, Result, Stage


@dataclass(frozen=True)
class Deviation(Result):
    """Distances in mm, the largest ones within 0.005 mm; None where the work was stopped. Documents of 0.1.0
    have no RMS, and largest ones of samples."""

    mean: Optional[float] = None
    largest: Optional[float] = None
    hausdorff: Optional[float] = None
    rms: Optional[float] = None

    def report(self) -> dict[str, Any]:
        if self.mean is None:
            return {}
        rms = {} if self.rms is None else {"rms_mm": self.rms}
        return {"deviation": {"mean_mm": self.mean, **rms, "max_mm": self.largest,
                              "hausdorff_mm": self.hausdorff}}


def _run(inputs: Inputs, job: Job) -> Deviation:
    target, design = inputs["target"], inputs["design"].design
    V, F = target.given
    mean, rms, largest, hausdorff = native.surface_deviation(design.V, design.F, V, F, job)
    return Deviation(mean, largest, hausdorff, rms)


STAGE = Stage("deviation", ("target", "design"), frozenset(), _run,
              on_stop=lambda stage, inputs: Deviation(),
              label="Deviation", asked_by=("solve",))
