// SPDX-License-Identifier: LGPL-2.1-or-later
// Verdict on a design, for verification and repair.
#pragma once

#include "curveups/physics/verification.hpp"

namespace curveups {

// A contact point presses with f_min at least.
inline bool presses(double normal_force, double f_min) { return normal_force >= f_min; }

// Pushing forces within friction reach f_min at every point, up to the tolerance of the cone
// program. scale: its unit of forces.
inline bool floor_is_reached(double largest_floor, double f_min, double scale) {
  return largest_floor >= f_min - UnilateralOptions{}.tolerance * scale;
}

// A membrane does not cut into a body. distance: mm, negative inside.
inline bool is_clear(double distance) { return distance >= 0; }

// A finer mesh may find that a membrane cuts in below this clearance, mm.
inline constexpr double safe_clearance = 0.05;

struct VerdictInput {
  const SolvedDesign& solved;
  const UnilateralResult& unilateral;
  const BalanceSystem& system;
  std::array<MembraneClearance, 2> clearance;
  std::vector<std::array<int, 2>> crossing;  // tiles where a sheet would lie on itself
};

// The reason that a membrane would cut into a tile's body, depth in mm.
Finding cut_by_membrane(Side side, int tile, double depth);

// Fills valid, reasons and warnings of a report whose figures are complete.
void give_verdict(const VerdictInput& input, VerificationReport& report);

}  // namespace curveups
