// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact forces in a repair step: values, goals and exact gradients, and the vertices that the
// step may move.
#pragma once

#include <vector>

#include "curveups/refinement/layout_step.hpp"
#include "curveups/refinement/tracked_forces.hpp"

namespace curveups {

// Places of vertices in Eq. 4, E_target = sum_j A_j |x_j - c_j|^2.
struct VertexPlaces {
  Points3 place;         // c_j, mm
  Eigen::VectorXd area;  // A_j, mm2: that of the tiles around each, a third from each
};

// Vertices of the tiles at points that must be lifted, and of the tiles next to these.
MovingVertices vertices_to_move(const Iterate& place, const TrackedForces& tracked,
                                const Judgement& now, const VertexPlaces& target);

// Row of the value and the gradient by the unknowns of layout and vertices, times a unit. moving
// may be null.
ForceRow make_force_row(const Iterate& place, double value, double unit,
                        const ForceGradient& gradient, const MovingVertices* moving);

// Rows of the points below the active force, and of the floor where that is active. moving may be
// null.
std::vector<ForceRow> force_rows(const Iterate& place, const TrackedForces& tracked,
                                 const Judgement& now, const MovingVertices* moving);

}  // namespace curveups
