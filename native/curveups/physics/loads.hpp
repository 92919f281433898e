// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads on tiles besides membranes and contacts: their weight, and the support that balances it.
#pragma once

#include "curveups/design/design.hpp"
#include "curveups/physics/balance_system.hpp"

namespace curveups {

// Direction of gravity in the coordinates of the target.
inline const Vec3 gravity_down = -Vec3::UnitZ();

// Weight of bodies (with recessed walls) and pins by the parameter density, M x 6, N and N mm about
// the tiles' centres; zero with gravity=off. Bumps, holes of joints and the sheets are left out,
// some 5 % together.
Wrenches weights(const DesignGeometry& geometry, const Array6& q, const Parameters& parameters);

// Tiles that carry the piece with gravity=held, ascending: the parameter held_tiles; by default the
// lowest tile of every piece and those that share a corner with it, about what fingers hold. None
// with another gravity.
std::vector<int> held_tiles(const DesignGeometry& geometry, const Parameters& parameters);

// Support of the weight.
struct Carried {
  Wrenches table;  // pushes of a table, M x 6; zero unless gravity=resting
  // First tile of every piece (tiles joined by contacts) without support, and of every piece that
  // tips over on the table, ascending.
  std::vector<int> in_the_air, tipping;
};

// With gravity=resting each piece stands on a level plane through the lowest corner of all bodies,
// on every corner within L / 20 of it. The table only pushes and, being level, needs no friction.
// The pushes are the least that balance the weight of a rigid piece, so that no tension of the
// membranes reaches the table. weight: weights().
Carried carry(const DesignGeometry& geometry, const Wrenches& weight, const Parameters& parameters);

}  // namespace curveups
