// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction that a design needs: the smallest coefficient mu at which forces in balance push with
// f_min at least at every contact point. s(mu), the largest s with |t| <= mu n - s at all points,
// is a cone program that always has a solution; mu is its root, by Newton's method with the
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
  // Tiles that need most: of at most 20 points, those with the most active cones.
  std::vector<int> tiles;
};

// Throws what make_balance_system throws, Cancelled.
FrictionNeeded find_friction_needed(const SolvedDesign& solved, const DesignGeometry& geometry,
                                    const Progress& progress);

}  // namespace curveups
