// SPDX-License-Identifier: LGPL-2.1-or-later
// From figures to reasons in words.
#pragma once

#include "curveups/physics/clearance.hpp"
#include "curveups/physics/validation.hpp"

namespace curveups {

struct VerdictInput {
  const TileMesh& tiles;
  const BalanceSystem& system;
  const ContactForces& forces;
  const UnilateralResult& coulomb;
  const UnilateralResult* tips;  // null without bumps
  const BalanceSystem* tips_system;
  std::array<MembraneClearance, 2> clearance;
  std::array<std::vector<int>, 2> slack_tiles;  // front, back: beside slack membrane
  bool floor_from_mesh;                         // f_min is the mesh's error, not f_min_ratio
};

// Fills valid, reasons and warnings of a report whose figures are complete.
void give_verdict(const VerdictInput& input, ValidationReport& report);

}  // namespace curveups
