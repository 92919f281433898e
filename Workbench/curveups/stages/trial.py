# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the design of a target in a copy of the project: what only a layout, its repair and the membranes'
equilibrium tell."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from ..base.errors import Stopped
from .stage import Inputs, Job

# Steps of repair for all that a stage tries: fillets that can be mended take some 20, and each takes up to
# half a second. Without an end four trials took four times as long as the design.
REPAIR_STEPS, MOST_TILES = 24, 1500
GOALS = ("clearances", "verification", "pieces")


def trial(inputs: Inputs, values: Mapping[str, Any], job: Job, steps: list[int],
          begun: Optional[Any] = None) -> Optional[Any]:
    """Results of a copy of the project with these values of parameters, which goes on from what is begun:
    GOALS, the first alone where repair ends with membranes that cut into bodies. None where repair takes more
    than the steps that are left, of which those it takes are taken off. Raises CurveUpsError where the target
    can't be made so, and Stopped."""
    def count(stage: str, *_: object) -> None:
        steps[0] -= stage == "repair"
        candidate.stopped |= steps[0] < 0

    candidate = Job(job, count)
    assert inputs.elsewhere is not None
    try:
        found = inputs.elsewhere(values, GOALS, candidate, begun, lambda made: bool(made["repair"].cuts))
    except Stopped:
        if job.stopped:
            raise
        return None
    if job.stopped:
        raise Stopped
    return None if candidate.stopped else found
