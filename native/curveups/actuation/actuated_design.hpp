// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the built piece: the minimum of its energy without friction, which shaking leads
// towards, and where it comes to rest on its way from flat: released, shaken, and pressed over its
// former and let go. Weight is left out: it is little beside what membranes store.
#pragma once

#include <optional>
#include <vector>

#include "curveups/actuation/path.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// How much stronger one membrane may be than the other, as sheets of one roll are: an assumption.
inline constexpr double membrane_mismatch = 0.05;

struct ActuatedDesign {
  double friction_coefficient = 0;
  int contacts = 0;  // of the design
  std::vector<PathFrame> frames;
  // None where it was stopped before.
  std::optional<RestState> relaxed, released, shaken, pressed;
  // Least and largest mean distance, mm, relaxed, shaken, and relaxed with the front or the back
  // membrane stronger by membrane_mismatch; where all of these came to rest.
  std::optional<std::array<double, 2>> spread;
  bool stopped = false;
  double largest_rise = 0, found_anew = 0, deepest = 0;  // as Path has them
};

// Stopped once the piece has relaxed, it returns what there is so far; before that it throws
// Cancelled. Throws what make_tile_bodies, solve_design and make_tile_world throw, SolverFailure.
ActuatedDesign actuate_design(const Design& design, const PathOptions& options,
                              const Progress& progress);

}  // namespace curveups
