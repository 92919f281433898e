// SPDX-License-Identifier: LGPL-2.1-or-later
// Breakaway support: thin bridges between neighbouring bodies. They lie just above the back faces:
// the front membrane is glued first, and the bridges are then broken from the back, the side that
// is glued second.
#pragma once

#include <array>
#include <vector>

#include "curveups/bodies/bumps.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/design/parameters.hpp"

namespace curveups {

// Two bodies to be joined, and lines of sight to try: a point between them and the direction from
// the first body to the second.
struct BridgeWish {
  int a, b;
  std::vector<std::array<Vec2, 2>> sight;  // point, unit direction; the best ones first
  int enough = 0;  // left out where b has so many bridges from earlier wishes; 0: never
};

struct Bridges {
  std::vector<PrintBody> bodies;
  std::vector<std::array<int, 2>> joined;  // per bridge
};

// A body that bridges join or must keep clear of: its convex body in print coordinates and the
// balls around its bumps and hollows.
struct BridgeObstacle {
  ConvexBody body;
  std::vector<Vec3> ball_centres;
  std::vector<double> ball_radii;
};

// Thickness of a bridge where it breaks, mm: above the notch.
double bridge_neck(const Parameters& parameters);

// One bridge per wish where one of its lines of sight is free: it enters both bodies by
// bridge_depth and keeps clear of their bumps, of the bridges of earlier wishes and, by d_gap_min,
// of third bodies. z: the height of the back faces.
// Throws InfeasibleDesign where the body is too thin for bridges with these notches.
Bridges make_bridges(const std::vector<BridgeObstacle>& bodies,
                     const std::vector<BridgeWish>& wishes, double z, const Parameters& parameters);

}  // namespace curveups
