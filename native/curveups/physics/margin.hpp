// SPDX-License-Identifier: LGPL-2.1-or-later
// Margin of a design: pushing forces with other sheets and less friction. The forces of a membrane
// are proportional to its thickness and modulus, so that the corners of the margin are two cone
// programs at loads that are known (unilateral.hpp). More friction only widens the cones.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "curveups/core/finding.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

struct Margin {
  std::string mode = "off";
  double mismatch = 0, friction_coefficient = 0;  // parameters (mismatch in %)
  // True where pushing forces of f_min within friction exist at both corners; without a value with
  // margin=off or where neither could be shown.
  std::optional<bool> met;
  // Failures with the front pulling harder, and with the back.
  std::array<std::optional<Finding>, 2> failure;
};

// solved: with the membranes in the actuated configuration. Throws what solve_unilateral and
// solve_contact_forces throw.
Margin find_margin(const SolvedDesign& solved, const DesignGeometry& geometry,
                   const Progress& progress);

}  // namespace curveups
