// SPDX-License-Identifier: LGPL-2.1-or-later
// Pins that have to grow: caps, upper bounds of their insets below the present ones.
#pragma once

#include <vector>

#include "curveups/physics/verdict.hpp"
#include "curveups/refinement/iterate.hpp"

namespace curveups {

// Tile that a membrane cuts into or all but touches.
struct Touch {
  int tile;
  Side side;
  double clearance;  // mm, negative where it cuts in
};

std::vector<Touch> find_touches(const DesignGeometry& geometry, const SolvedDesign& solved);

// Draws out the pins around touches, as pins nearer to their edges hold a membrane up better: caps
// the insets of the tiles touched, and of those next to them, below the present ones. False where
// none can give way.
bool cap_insets(const std::vector<Touch>& touches, const Iterate& place, Array6& caps);

// Bounds the insets of a geometry by caps; each keeps a little room.
void apply_caps(const Array6& caps, DesignGeometry& geometry);

}  // namespace curveups
