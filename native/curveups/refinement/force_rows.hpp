// SPDX-License-Identifier: LGPL-2.1-or-later
// What a repair step sees of the contact forces: values, goals and exact gradients, and the
// vertices it may move.
#pragma once

#include <vector>

#include "curveups/refinement/layout_step.hpp"
#include "curveups/refinement/merit_terms.hpp"
#include "curveups/refinement/tracked_forces.hpp"

namespace curveups {

// The vertices of the tiles at points that must be lifted, and of the tiles next to these. target:
// where vertices belong.
MovingVertices vertices_to_move(const Iterate& place, const TrackedForces& tracked,
                                const Judgement& now, const RepairOptions& options,
                                const TargetDistance& target);

// A row per point below the active force, whose goal is `goal` times f_min, and one for each
// floor that is active. moving may be null.
std::vector<ForceRow> force_rows(const Iterate& place, const TrackedForces& tracked,
                                 const Judgement& now, const RepairOptions& options, double goal,
                                 const MovingVertices* moving);

}  // namespace curveups
