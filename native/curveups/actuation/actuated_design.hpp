// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the built piece: at the minimum of its energy without friction, towards which shaking
// leads, and at rest on its way from flat: released, shaken, and pressed over its former and let
// go. Weight is left out: it is little beside the energy of the membranes.
#pragma once

#include <optional>
#include <vector>

#include "curveups/actuation/path.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// Possible excess of one membrane's strength over the other's, for sheets of one roll: an
// assumption.
inline constexpr double membrane_mismatch = 0.05;

struct ActuatedDesign {
  double friction_coefficient = 0;
  int contacts = 0;  // in the design
  std::vector<PathFrame> frames;
  // None where the work was stopped before.
  std::optional<RestState> relaxed, released, shaken, pressed;
  // Least and largest mean distance, mm, relaxed, shaken, and relaxed with the front or the back
  // membrane stronger by membrane_mismatch; where all of these came to rest.
  std::optional<std::array<double, 2>> spread;
  bool stopped = false;
};

// Stopped once the piece has relaxed, returns the states so far; before that throws Cancelled.
// Throws what make_tile_bodies, solve_design and make_tile_world throw, SolverFailure.
ActuatedDesign actuate_design(const Design& design, const PathOptions& options,
                              const Progress& progress);

}  // namespace curveups
