# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the stages of the work, in the order in which reports show their results."""

from . import (actuation, design, division, feasibility, layout, pieces, repair, settle, sheets, sizes,
               smoothing, solids, suggestions, surface, target, verification)

STAGES = (surface.STAGE, target.STAGE, smoothing.TARGET, division.STAGE, feasibility.STAGE,
          sizes.STAGE, division.CUTS, suggestions.SEARCH, smoothing.STAGE, layout.STAGE,
          verification.OF_LAYOUT, repair.STAGE, design.STAGE, design.FIGURES, design.DEVIATION,
          design.CLEARANCES, verification.STAGE, pieces.STAGE, sheets.ANCHORING,
          solids.BODIES, sheets.STAGE, solids.STAGE, settle.STAGE, actuation.STAGE, solids.CHECK,
          suggestions.STAGE)

BY_NAME = {stage.name: stage for stage in STAGES}
VERDICT = verification.STAGE.name
SETTLED = settle.STAGE.name
RISEN = actuation.STAGE.name


def stages_of(*commands: str) -> tuple[str, ...]:
    """Names of the stages that these commands run, in the order of the stages."""
    return tuple(stage.name for stage in STAGES if set(commands) & set(stage.commands))


def label_of(name: str) -> str:
    """Name of a stage for users."""
    return BY_NAME[name].label if name in BY_NAME else name
