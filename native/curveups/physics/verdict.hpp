// SPDX-License-Identifier: LGPL-2.1-or-later
// Defines when a design holds. Verification reports by it, and repair works towards it.
#pragma once

#include "curveups/physics/solved_design.hpp"
#include "curveups/physics/verification_report.hpp"

namespace curveups {

// A contact point presses with f_min at least.
inline bool presses(double normal_force, double f_min) { return normal_force >= f_min; }

// Pushing forces within friction reach f_min at every point, as far as the cone program tells.
// scale: the unit of forces that the program was solved in.
inline bool floor_is_reached(double largest_floor, double f_min, double scale) {
  return largest_floor >= f_min - UnilateralOptions{}.tolerance * scale;
}

// A membrane does not cut into a body. distance: mm, negative inside.
inline bool is_clear(double distance) { return distance >= 0; }

// Below this a finer mesh may find that a membrane cuts in, mm.
inline constexpr double safe_clearance = 0.05;

struct VerdictInput {
  const SolvedDesign& solved;
  const UnilateralResult& unilateral;
  const BalanceSystem& system;
  std::array<MembraneClearance, 2> clearance;
  std::array<std::vector<int>, 2> slack_tiles;  // front, back: beside slack membrane
  std::vector<std::array<int, 2>> crossing;     // tiles where a sheet would lie on itself
};

// The reason that a membrane would cut into a tile's body, depth in mm.
Finding cut_by_membrane(Side side, int tile, double depth);

// Fills valid, reasons and warnings of a report whose figures are complete.
void give_verdict(const VerdictInput& input, VerificationReport& report);

}  // namespace curveups
