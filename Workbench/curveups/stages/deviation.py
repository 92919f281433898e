# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures how far the actuated surface is from the target as the user gave it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

from ..base.native import native
from .stage import Inputs, Job, Result, Stage


@dataclass(frozen=True)
class Deviation(Result):
    """Distances in mm; the largest ones within 0.005 mm."""

    mean: float
    rms: float
    largest: float
    hausdorff: float

    def report(self) -> dict[str, Any]:
        return {"deviation": {"mean_mm": self.mean, "rms_mm": self.rms, "max_mm": self.largest,
                              "hausdorff_mm": self.hausdorff}}


def _run(inputs: Inputs, job: Optional[Job] = None) -> Deviation:
    target, design = inputs["target"], inputs["design"].design
    V, F = target.given
    return Deviation(*native.surface_deviation(design.V, design.F, V, F, job))


STAGE = Stage("deviation", ("target", "design"), frozenset(), _run,
              on_stop=lambda stage, inputs: _run(inputs),
              label="Deviation", asked_by=("solve",))
