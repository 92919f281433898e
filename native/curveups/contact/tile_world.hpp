// SPDX-License-Identifier: LGPL-2.1-or-later
// A design's tiles as rigid bodies under their membranes and their weight, standing where they
// stand when actuated: what settles, and what rises from flat.
#pragma once

#include "curveups/bodies/tile_bodies.hpp"
#include "curveups/contact/contact_world.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// The tiles are bodies 0 to tile_count - 1, in their order, about their centres (tile_centres),
// with axes parallel to the world's at the start. Nodes of the membranes follow, then the ground
// where the piece rests on one.
struct TileWorld {
  std::unique_ptr<ContactWorld> world;
  int tile_count = 0;
};

// What stands on walls are bumps as they are made, else the walls touch. Membranes are reduced
// (reduced_membrane.hpp); to their forces are added the differences from those of the finite
// elements in the actuated configuration, as forces that neighbours exert on one another: at the
// start the wrenches on all tiles are those of `solved`. tile_modulus: Young's, MPa. Throws what
// plan_bumps throws.
TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          double tile_modulus);

}  // namespace curveups
