// SPDX-License-Identifier: LGPL-2.1-or-later
// Reasons why the bodies of tiles make a design not valid. They need no solids.
#pragma once

#include <vector>

#include "curveups/bodies/clearance.hpp"
#include "curveups/core/finding.hpp"

namespace curveups {

// None where tiles stand apart in the flat layout and, when actuated, share no more than
// tolerance::overlap_volume. flat: min_clearance_flat, actuated: max_overlap_actuated.
std::vector<Finding> body_reasons(const PairFigure& flat, const PairFigure& actuated);

}  // namespace curveups
