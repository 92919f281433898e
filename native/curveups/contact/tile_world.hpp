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
  // Factors on how far both are stretched along x and y of the layout.
  Vec2 stretch = Vec2::Ones();
  double growth = 0;  // mm by which every wall of the print has grown
  double taper = 0;   // mm by which walls have grown more at the front
  // How half of the layout has moved when both membranes are glued to it: mm away from the other
  // half, degrees counter-clockwise about the layout's middle.
  double half_shift = 0, half_turn = 0;

  bool operator==(const Conditions& other) const;
};

// What `set` starts from. A side's corrections are what the tiles feel less by the reduced membrane
// than by the finite elements.
struct DesignedWorld {
  int tile_count = 0;
  double L = 0, H_body = 0;
  std::array<std::vector<PairLoad>, 2> corrections;
  std::array<Points3, 2> pin_corners;   // as points of their tiles
  std::array<Points2, 2> flat_corners;  // of pins, in the layout
  std::vector<ContactPoint> interface;  // where neighbours exert corrections
  std::vector<RigidBody> bodies;
  Points3 normals;                         // of the tiles' fronts
  std::vector<std::vector<char>> is_wall;  // of each tile's faces
  Poses start;
};

// The tiles are bodies 0 to tile_count - 1, in their order, about their centres (tile_centres),
// with axes parallel to the world's at the start. Nodes of the membranes follow, then the ground
// where the piece rests on one.
struct TileWorld {
  std::unique_ptr<ContactWorld> world;
  int tile_count = 0;

  // From here on, with the tiles where they are.
  void set(const Conditions& conditions);

  // Where the corners of a side's pins are now, as solve_membranes numbers them.
  Points3 pin_corners(Side side) const;
  // Solves the finite elements of the membranes, `solved`, with the pins where they are now, and,
  // where the tiles feel something else by more than `enough`, makes them feel that: the design as
  // it stands does so from here on. Returns by how much: the largest force, or torque over L, over
  // the mean force on a tile. Throws SolverFailure where a membrane finds no equilibrium,
  // Cancelled.
  double solve_elements(SolvedDesign& solved, double enough);

  // A world of its own, at the start under the conditions of the design as it stands.
  TileWorld copy() const;

  DesignedWorld designed;
  Conditions conditions;
  // The world's own energies.
  std::array<ReducedMembrane*, 2> membranes{};
  std::array<PairLoads*, 2> corrections{};
  PointLoads* weight = nullptr;
};

// What stands on walls are bumps as they are made, else the walls touch. Membranes are reduced
// (reduced_membrane.hpp); to their forces are added the differences from those of the finite
// elements in the actuated configuration, as forces that neighbours exert on one another: at the
// start the wrenches on all tiles are those of `solved`. tile_modulus: Young's, MPa. Throws what
// plan_bumps throws.
TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          double tile_modulus);

}  // namespace curveups
