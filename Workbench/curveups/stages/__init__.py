# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lists the stages of the work, one file each, in the order in which reports show their results."""

from . import (anchoring, clearances, cuts, design, deviation, division, fairing, feasibility, layout, pieces,
               relief, repair, sizes, solids, suggestions, surface, target, trials, verification)

STAGES = (surface.STAGE, target.STAGE, fairing.STAGE, division.STAGE, feasibility.STAGE, sizes.STAGE,
          cuts.STAGE, suggestions.SEARCH, relief.STAGE, layout.STAGE, verification.OF_LAYOUT, repair.STAGE,
          design.STAGE, design.FIGURES, deviation.STAGE, clearances.STAGE, verification.STAGE,
          verification.RECHECK, pieces.STAGE, anchoring.STAGE, solids.BODIES, solids.STAGE, solids.CHECK,
          trials.STAGE, suggestions.STAGE)

# What is known of a target without a design; what prints are made of; all that is known of a design without
# them, but for cuts that nobody asked for.
CHECKED = (feasibility.STAGE.name, sizes.STAGE.name)
PRINTED = (solids.BODIES.name, solids.STAGE.name, solids.CHECK.name)
DESIGNED = tuple(stage.name for stage in STAGES
                 if stage.name not in (suggestions.SEARCH.name, *CHECKED, *PRINTED))
