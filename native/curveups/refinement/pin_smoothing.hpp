// SPDX-License-Identifier: LGPL-2.1-or-later
// Smoothing for pin sides that no layout can give A_pin_min because the folds around their tile
// leave too little of its face. The least movement of vertices in the sense of Eq. 4, sum_j A_j
// |x_j - c_j|^2, makes them feasible. It comes before any layout, as folds alone decide.
#pragma once

#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

struct PinSmoothing {
  TriangleMesh mesh;              // the given one, bit for bit, where there was nothing to do
  double largest_move = 0;        // mm, of a vertex
  std::vector<SmallPin> reached;  // sides below A_pin_min that now reach it, with their area before
  std::vector<SmallPin> remaining;
};

// No coordinate of a vertex moves farther than L / 30: farther, membranes begin to cut into tiles
// beside the dents. Folds beyond 0.3 rad do not become sharper. Sides out of reach are left as they
// are, and no vertex moves for them. Throws what make_geometry throws for the given mesh;
// Cancelled.
PinSmoothing smooth_for_pins(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters, const Progress& progress);

}  // namespace curveups
