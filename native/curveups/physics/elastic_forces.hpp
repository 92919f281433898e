// SPDX-License-Identifier: LGPL-2.1-or-later
// What the membranes do to the tiles (paper, A.1): forces on pin outlines, gathered to the pins'
// corners by the mesh's weights, and summed up to one wrench per tile.
#pragma once

#include "curveups/physics/equilibrium.hpp"

namespace curveups {

// M x 6: force (N) and torque (N mm) on each tile, the torque about the tile's centre.
using Wrenches = Array6;

// Reference points of torques: the centroids of the front triangles, M x 3.
Points3 tile_centres(const TileMesh& tiles);

// 3 M x 3: the membrane's pull on every pin corner.
Points3 pin_corner_forces(const MembraneMesh& mesh, const MembraneState& state, int tile_count);

// Adds the wrenches of forces at pin corners.
void add_wrenches(const Points3& corner_forces, const Points3& corners, const Points3& centres,
                  Wrenches& wrenches);

// Largest absolute sum over all tiles of the forces, and of the torques about one point divided by
// `lever`, relative to the mean force on a tile.
struct WrenchBalance {
  double force, torque;
};
WrenchBalance wrench_balance(const Wrenches& wrenches, const Points3& centres, double lever);

}  // namespace curveups
