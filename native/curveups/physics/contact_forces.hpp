// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact forces by least squares (paper, Eqs. 1 and 2): the smallest forces that balance every
// tile, of contacts that may pull and bear any friction.
#pragma once

#include "curveups/design/contacts.hpp"
#include "curveups/physics/balance_system.hpp"

namespace curveups {

// The corners of all interfaces as contact points, in the order of the contacts.
std::vector<ContactPoint> interface_points(const TileMesh& tiles,
                                           const std::vector<ContactPatch>& patches);

struct ContactForces {
  Points3 force;           // per point, in its basis: normal (pushing positive) and two tangents, N
  double normal_mean = 0;  // N
  double normal_min = 0;
  int weakest_point = -1;
  // Largest unbalanced force, or torque over the lever, of a tile, relative to the mean load on
  // one; beyond rounding only where contacts can't hold a tile (hinges).
  double imbalance = 0;
  std::vector<int> unbalanced_tiles;
};

// loads: all that acts on the tiles besides contacts. The system's factorization is left at A A^T.
ContactForces solve_contact_forces(BalanceSystem& system, const Wrenches& loads);

}  // namespace curveups
