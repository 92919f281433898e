// SPDX-License-Identifier: LGPL-2.1-or-later
// A design's tiles as rigid bodies under their membranes and their weight, at first in the actuated
// configuration. They settle there, or rise from flat (actuation).
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

// Young's modulus of printed tiles, MPa, by which walls and bumps give way: an assumption.
inline constexpr double tile_modulus = 2000;

// The tiles are bodies 0 to tile_count - 1, in their order, about their centres (tile_centres),
// with axes parallel to the world's at the start. Nodes of the membranes follow, then the ground
// where the piece rests on one.
struct TileWorld {
  std::unique_ptr<ContactWorld> world;
  int tile_count = 0;
  double L = 0;
  Poses start;
  std::array<MembraneDomain, 2> domain;  // patches of each side's membrane
  std::array<Points3, 2> pins;           // pin corners per side, as points of their tiles
  std::vector<ContactPoint>
      interface;  // points of the corrections between neighbours, at the start
  // Energies of the world. A side's corrections are the differences of forces on tiles between the
  // finite elements and the reduced membrane.
  std::array<ReducedMembrane*, 2> membranes{};
  std::array<PairLoads*, 2> corrections{};

  // Corners of a side's pins with the tiles at these poses, as solve_membranes numbers them.
  Points3 pin_corners(Side side, const Poses& poses) const;
  // Solves the finite elements of the membranes, `solved`, with the pins at their present places.
  // Returns the largest difference of a force, or torque over L, from those in the world, over the
  // mean force on a tile; where it is above the tolerance, the corrections follow the elements.
  // Throws SolverFailure where a membrane finds no equilibrium, Cancelled.
  double solve_elements(SolvedDesign& solved, double tolerance);
};

// Nodes of a reduced membrane, each amid its polygon's pin corners.
Poses membrane_nodes(const MembraneDomain& domain, const Points3& pin_corners);

// Normal force of each contact, N.
Eigen::VectorXd contact_pushes(const TileMesh& tiles, const ContactWorld& world);

// Tiles touch with their bumps, or with walls where these have none. Membranes are reduced
// (reduced_membrane.hpp) and corrected by forces between neighbours, so that at the start the
// wrenches on all tiles are those of `solved`, times `pull` of each side's membrane: forces are
// proportional to a membrane's thickness and modulus. Throws what plan_bumps throws.
TileWorld make_tile_world(const TileBodies& bodies, const SolvedDesign& solved,
                          const std::array<double, 2>& pull = {1, 1});

}  // namespace curveups
