// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads on tiles besides membranes and contacts: their weight, and what carries it.
#pragma once

#include "curveups/design/design.hpp"
#include "curveups/physics/balance_system.hpp"

namespace curveups {

// Direction of gravity in the coordinates of the target.
inline const Vec3 gravity_down = -Vec3::UnitZ();

// M x 6, N and N mm about the tiles' centres: what is printed, by parameter density, with pins and
// bumps (recessed as printed), and the membranes, each free part shared by the tiles around it and
// hanging at their pins' tops. Zero without gravity. Throws what plan_bumps throws.
Wrenches weights(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                 const Parameters& parameters);

// The tiles that carry the piece where gravity is held, ascending: held_tiles, by default of every
// piece the lowest one and those that share a corner with it, about what fingers hold. None
// otherwise.
std::vector<int> held_tiles(const DesignGeometry& geometry, const Parameters& parameters);

// Where the weight goes.
struct Carried {
  Wrenches table;  // what a table pushes, M x 6; zero where gravity is not resting
  // The first tile of every piece (tiles joined by contacts) that nothing carries, and of every
  // piece that tips over on the table, ascending.
  std::vector<int> in_the_air, tipping;
};

// Where gravity is resting each piece stands on a level plane through the lowest corner of all
// bodies; every corner within L / 20 of it touches. A table only pushes. As it is level the weight
// asks for no friction, and the least pushes that balance the weight of a rigid piece are one
// answer whatever the membranes do: nothing of their tension reaches the table. weight: weights().
Carried carry(const DesignGeometry& geometry, const Wrenches& weight, const Parameters& parameters);

}  // namespace curveups
