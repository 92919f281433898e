# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the design of a target in a copy of the project: what only a layout, its repair and the membranes'
equilibrium tell."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence

from ..base.errors import Stopped
from .stage import Inputs, Job

# Steps of repair for all that a stage tries: fillets that can be mended take some 20, and each takes up to
# half a second. Without an end four trials took four times as long as the design.
REPAIR_STEPS, MOST_TILES = 24, 1500


def trial(inputs: Inputs, values: Mapping[str, Any], goals: Sequence[str], job: Job, steps: list[int],
          after: Optional[Any] = None) -> Optional[Any]:
    """Results of a copy of the project with these values of parameters, made after those of such a copy;
    None where repair takes more than the steps that are left, of which those it takes are taken off. Where
    membranes cut into bodies after repair, no later results. Raises CurveUpsError where the target can't be
    made so, and Stopped."""
    def count(stage: str, *_: object) -> None:
        steps[0] -= stage == "repair"
        candidate.stopped |= steps[0] < 0

    candidate = Job(job, count)
    assert inputs.elsewhere is not None
    try:
        found = inputs.elsewhere(values, ("repair",), candidate, after)
        if not candidate.stopped and not found["repair"].cut:
            found = inputs.elsewhere(values, goals, candidate, found)
    except Stopped:
        if job.stopped:
            raise
        return None
    if job.stopped:
        raise Stopped
    return None if candidate.stopped else found
