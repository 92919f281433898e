// SPDX-License-Identifier: LGPL-2.1-or-later
// A design's tiles as rigid bodies under their membranes and their weight, standing where they
// stand when actuated: what settles, and what rises from flat.
#pragma once

#include "curveups/bodies/tile_bodies.hpp"
#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/given_forces.hpp"
#include "curveups/contact/reduced_membrane.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// What may differ from the design as it stands.
struct Conditions {
  std::array<double, 2> pull = {1, 1};  // factors on how hard front and back membrane pull
  double stretch = 1;                   // factor on how far both are stretched
  double growth = 0;                    // mm by which every wall of the print has grown

  bool operator==(const Conditions& other) const {
    return pull == other.pull && stretch == other.stretch && growth == other.growth;
  }
};

// The tiles are bodies 0 to tile_count - 1, in their order, about their centres (tile_centres),
// with axes parallel to the world's at the start. Nodes of the membranes follow, then the ground
// where the piece rests on one.
struct TileWorld {
  std::unique_ptr<ContactWorld> world;
  int tile_count = 0;

  // From here on, with the tiles where they are.
  void set(const Conditions& conditions);

  // The world's own energies, and what `set` starts from. A side's corrections are what the tiles
  // feel less by the reduced membrane than by the finite elements.
  std::array<ReducedMembrane*, 2> membranes{};
  std::array<PairLoads*, 2> corrections{};
  std::array<std::vector<PairLoad>, 2> designed_corrections;
  std::vector<RigidBody> designed_bodies;
  std::vector<std::vector<char>> is_wall;  // of each tile's faces
  Poses start;
  double growth = 0;
};

// What stands on walls are bumps as they are made, else the walls touch. Membranes are reduced
// (reduced_membrane.hpp); to their forces are added the differences from those of the finite
// elements in the actuated configuration, as forces that neighbours exert on one another: at the
// start the wrenches on all tiles are those of `solved`. tile_modulus: Young's, MPa. Throws what
// plan_bumps throws.
TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          double tile_modulus);

}  // namespace curveups
