// SPDX-License-Identifier: LGPL-2.1-or-later
// A design's tiles as rigid bodies under their membranes and their weight, standing where they
// stand when actuated: what settles, and what rises from flat.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "curveups/bodies/tile_print.hpp"
#include "curveups/contact/contact_world.hpp"
#include "curveups/contact/given_forces.hpp"
#include "curveups/contact/reduced_membrane.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// Young's modulus of printed tiles, MPa: an assumption. It says how far walls and bumps give way.
inline constexpr double tile_modulus = 2000;

// The tiles are bodies 0 to tile_count - 1, in their order, about their centres (tile_centres),
// with axes parallel to the world's at the start. Nodes of the membranes follow, then the ground
// where the piece rests on one.
struct TileWorld {
  std::unique_ptr<ContactWorld> world;
  int tile_count = 0;
  double L = 0;
  Poses start;
  std::array<Points3, 2> pins;          // pin corners of a side, as points of their tiles
  std::vector<ContactPoint> interface;  // where neighbours exert corrections, at the start
  // The world's own energies. A side's corrections are what the tiles feel less by the reduced
  // membrane than by the finite elements.
  std::array<ReducedMembrane*, 2> membranes{};
  std::array<PairLoads*, 2> corrections{};

  // Where the corners of a side's pins are now, as solve_membranes numbers them.
  Points3 pin_corners(Side side) const;
  // Solves the finite elements of the membranes, `solved`, with the pins where they are now, and,
  // where the tiles feel something else by more than `enough`, makes them feel that. Returns by how
  // much: the largest force, or torque over L, over the mean force on a tile. Throws SolverFailure
  // where a membrane finds no equilibrium, Cancelled.
  double solve_elements(SolvedDesign& solved, double enough);
};

// What stands on walls are bumps as they are made, else the walls touch. Membranes are reduced
// (reduced_membrane.hpp); to their forces are added the differences from those of the finite
// elements in the actuated configuration, as forces that neighbours exert on one another: at the
// start the wrenches on all tiles are those of `solved`, times `pull` of each side's membrane: its
// forces are proportional to its thickness and modulus. Throws what plan_bumps throws.
TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          const std::array<double, 2>& pull = {1, 1});

}  // namespace curveups
