# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes the load of the surplus membrane on the anchors, from the parameters alone.

Before the surplus is cut off it pulls at the outline (paper, section 6.2), there with all the tension of
a sheet that is stretched alike in both directions: of a neo-Hookean one T = G h (1 - tau^-6) N/mm, from the
Cauchy stress G (tau^2 - tau^-4) on the thickness h / tau^2. An anchor takes that along its spacing, with the
glue on one of its ends for each sheet.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Mapping, Sequence

from ..base.findings import Finding
from ..base.native import native
from .stage import Inputs, Job, Result, Stage

SIDES = ("front", "back")


@dataclass(frozen=True)
class Anchoring(Result):
    """Pull (N) and shear (MPa) of the glue of one anchor, front and back; nothing without anchors."""

    block: Mapping[str, Any] = field(default_factory=dict)
    strength: float = math.inf  # MPa

    def report(self) -> dict[str, Any]:
        return {"anchors": dict(self.block)} if self.block else {}

    def warnings(self) -> Sequence[Finding]:
        worst = max(self.block.get("glue_shear_mpa", (0.0,)))
        if worst <= self.strength:
            return ()
        return (Finding.about("anchor", pull=max(self.block["pull_n"]), shear=worst, limit=self.strength),)


def _run(inputs: Inputs, job: Job) -> Anchoring:
    get = inputs.parameters.get
    if not get("anchors"):
        return Anchoring()
    tension = native.surplus_tension(inputs.parameters)
    pull = [native.ANCHOR_SPACING * each for each in tension]
    area = math.pi * get("anchor_radius") ** 2
    return Anchoring({"surplus_tension_n_per_mm": list(tension), "pull_n": pull,
                      "glue_shear_mpa": [each / area for each in pull]}, get("glue_strength"))


STAGE = Stage("anchoring", (), frozenset({"layout", "support", "physics"}), _run,
              on_stop=lambda stage, inputs: Anchoring(),
              label="Anchors", asked_by=("solve",))
