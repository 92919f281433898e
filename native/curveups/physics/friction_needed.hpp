// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that a design needs: the smallest coefficient mu at which forces in balance exist that
// push with f_min at least at every contact point. s(mu), the largest s with |t| <= mu n - s at all
// points, is a cone program that always has a solution; mu is its root, by Newton's method with the
// program's multipliers.
#pragma once

#include <optional>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

struct FrictionNeeded {
  // An upper bound, by about 0.005: forces within it exist. None where no friction does, or where
  // it could not be shown.
  std::optional<double> coefficient;
  std::vector<int>
      tiles;  // that need most: of the points whose cones are active, at most 20 points
};

// Throws what make_balance_system throws, Cancelled.
FrictionNeeded find_friction_needed(const SolvedDesign& solved, const DesignGeometry& geometry,
                                    const Progress& progress);

}  // namespace curveups
