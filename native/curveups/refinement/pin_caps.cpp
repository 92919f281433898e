// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/pin_caps.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

// Pins grow until the glue has this much to spare: their neighbours' growth changes their load.
constexpr double glue_reserve = 1.1;
constexpr double least_move = 0.01;  // mm of an inset that is worth another fresh mesh

double around(const std::array<Vec2, 3>& corner) {
  return (corner[1] - corner[0]).norm() + (corner[2] - corner[1]).norm() +
         (corner[0] - corner[2]).norm();
}

}  // namespace

bool cap_insets(const std::vector<Touch>& touches, const Iterate& place, Array6& caps) {
  const PinBounds& bounds = place.geometry().pin_bounds;
  const MeshTopology& topology = place.geometry().tiles.topology;
  bool any = false;
  auto cap = [&](int tile, const Touch& touch) {
    for (int t = 0; t < 3; ++t) {
      const int k = inset_index(touch.side, t);
      const double q = std::min(place.state(tile, inset_unknown(touch.side, t)), caps(tile, k));
      const double lower = bounds.lower(tile, k) + least_capped_range;
      const double drawn = std::max(lower, q - 0.1 - 2 * (safe_clearance - touch.clearance));
      if (!(drawn < q - least_move)) continue;
      caps(tile, k) = drawn;
      any = true;
    }
  };
  for (const Touch& touch : touches) {
    cap(touch.tile, touch);
    for (int t = 0; t < 3; ++t) {
      const int n = topology.neighbour(touch.tile, t);
      if (n >= 0) cap(n, touch);
    }
  }
  return any;
}

bool cap_overloaded(const GlueLoads& loads, const Iterate& place, Array6& caps) {
  const TileMesh& tiles = place.geometry().tiles;
  const PinBounds& bounds = place.geometry().pin_bounds;
  const Array6 insets = place.insets();
  bool any = false;
  for (const std::vector<GlueLoad>& of_side : loads) {
    for (const GlueLoad& load : of_side) {
      if (!(load.shear > load.limit)) continue;
      const double area = pin_area(tiles, load.tile, load.side, insets.row(load.tile).data());
      // A pin is similar to its face: the root of its area is linear in the inset of all its edges.
      const double grown = std::sqrt(glue_reserve * load.shear / load.limit) - 1;
      const double circumference =
          around(pin_corners(tiles, load.tile, load.side, insets.row(load.tile).data()));
      const double inward = 2 * area * grown / circumference;
      for (int t = 0; t < 3; ++t) {
        const int k = inset_index(load.side, t);
        const double q = insets(load.tile, k);
        const double drawn = std::max(bounds.lower(load.tile, k) + least_capped_range, q - inward);
        if (!(drawn < q - least_move)) continue;
        caps(load.tile, k) = drawn;
        any = true;
      }
    }
  }
  return any;
}

}  // namespace curveups
