// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the built piece: where a design comes to rest after it is released from flat, shaken,
// and pressed over its former and let go. Weight is left out: it is little beside what membranes
// store.
#pragma once

#include <optional>
#include <vector>

#include "curveups/actuation/path.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

struct ActuatedDesign {
  double friction_coefficient = 0;
  int contacts = 0;  // of the design
  std::vector<PathFrame> frames;
  std::optional<RestState> released, shaken, pressed;  // none where it was stopped before
  bool stopped = false;
  double largest_rise = 0, found_anew = 0, deepest = 0;  // as Path has them
};

// Stopped while tiles move, it returns the path so far; before that
// it throws Cancelled. Throws what make_tile_bodies, solve_design and make_tile_world throw.
ActuatedDesign actuate_design(const Design& design, const PathOptions& options,
                              const Progress& progress);

}  // namespace curveups
