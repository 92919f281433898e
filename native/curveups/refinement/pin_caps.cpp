// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/pin_caps.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

constexpr double least_move = 0.01;  // mm of an inset that is worth another fresh mesh

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

}  // namespace curveups
