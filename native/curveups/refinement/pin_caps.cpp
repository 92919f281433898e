// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/pin_caps.hpp"

#include <algorithm>
#include <cmath>

namespace curveups {
namespace {

constexpr double least_move = 0.01;    // mm of an inset that is worth another fresh mesh
constexpr double least_range = 0.005;  // mm: room of an inset above its lower bound

}  // namespace

std::vector<Touch> find_touches(const DesignGeometry& geometry, const SolvedDesign& solved) {
  std::vector<Touch> touches;
  for (Side side : {Side::front, Side::back}) {
    const MembraneSolution& membrane = solved.membranes[static_cast<int>(side)];
    for (const MembraneClearance& clearance :
         patch_clearances(geometry, membrane, solved.design.parameters.H_pin)) {
      if (clearance.distance < safe_clearance) {
        touches.push_back({clearance.tile, side, clearance.distance});
      }
    }
  }
  return touches;
}

bool cap_insets(const std::vector<Touch>& touches, const Iterate& place, Array6& caps) {
  const PinBounds& bounds = place.geometry().pin_bounds;
  const MeshTopology& topology = place.geometry().tiles.topology;
  bool any = false;
  auto cap = [&](int tile, const Touch& touch) {
    for (int t = 0; t < 3; ++t) {
      const int k = inset_index(touch.side, t);
      const double q = std::min(place.state(tile, inset_unknown(touch.side, t)), caps(tile, k));
      const double lower = bounds.lower(tile, k) + least_range;
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

void apply_caps(const Array6& caps, DesignGeometry& geometry) {
  PinBounds& bounds = geometry.pin_bounds;
  bounds.upper =
      bounds.upper.cwiseMin(caps.cwiseMax((bounds.lower.array() + least_range).matrix()));
}

}  // namespace curveups
