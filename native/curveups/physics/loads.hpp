// SPDX-License-Identifier: LGPL-2.1-or-later
// Loads on tiles besides membranes and contacts: their weight, and what carries it.
#pragma once

#include "curveups/design/design.hpp"
#include "curveups/physics/balance_system.hpp"

namespace curveups {

// M x 6, N and N mm about the tiles' centres: what is printed, by parameter density, with pins and
// bumps (recessed as printed), and the membranes, each free part shared by the tiles around it and
// hanging at their pins' tops. Zero without gravity. Throws what plan_bumps throws.
Wrenches weights(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                 const Parameters& parameters);

// The tiles that carry the piece where gravity is held, ascending: held_tiles, by default of every
// piece the lowest one and those that share a corner with it, about what fingers hold. None
// otherwise.
std::vector<int> held_tiles(const DesignGeometry& geometry, const Parameters& parameters);

// Where gravity is resting: on a plane across its direction through the lowest corner of the tiles'
// bodies; every corner within L / 20 of it touches. None otherwise.
std::vector<ContactPoint> ground_points(const DesignGeometry& geometry,
                                        const Parameters& parameters);

// The first tile of every piece (tiles joined by contacts) that neither is held nor touches the
// ground, ascending; none without gravity.
std::vector<int> pieces_in_the_air(const DesignGeometry& geometry, const Parameters& parameters);

}  // namespace curveups
