// SPDX-License-Identifier: LGPL-2.1-or-later
// What of tiles' bodies makes a design not valid, in words: known without solids.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/clearance.hpp"

namespace curveups {

// None where tiles stand apart in the flat layout and, when actuated, share no more than
// tolerance::overlap_volume. flat: min_clearance_flat, actuated: max_overlap_actuated.
std::vector<std::string> body_reasons(const PairFigure& flat, const PairFigure& actuated);

}  // namespace curveups
