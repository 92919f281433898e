// SPDX-License-Identifier: LGPL-2.1-or-later
// What acts on tiles besides membranes and one another: their weight, and what carries it.
#pragma once

#include "curveups/design/design.hpp"
#include "curveups/physics/balance_system.hpp"

namespace curveups {

struct GravityLoad {
  Wrenches weight;                   // M x 6, N and N mm about the tiles' centres
  std::vector<int> held;             // ascending; empty unless the piece is held
  std::vector<ContactPoint> ground;  // empty unless it rests on a plane
};

// Parameters gravity, density (g / cm3) and direction. "held": by held_tiles, by default the
// lowest one of every piece. "resting": on a plane across the direction through the lowest corner;
// every corner of a tile's body within L / 20 of it touches. No gravity: zero weight, nothing held.
// Pins, bumps and membranes weigh nothing here.
GravityLoad gravity_load(const DesignGeometry& geometry, const Parameters& parameters);

}  // namespace curveups
