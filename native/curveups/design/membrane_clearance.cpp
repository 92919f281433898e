// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/membrane_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/design/flat_rim.hpp"
#include "curveups/design/pins.hpp"

namespace curveups {

std::vector<std::vector<int>> tiles_around_inner_vertices(const TileMesh& tiles) {
  std::vector<std::vector<int>> around = tiles_at_vertices(tiles);
  const std::vector<char> open = open_vertices(tiles);
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (open[v]) around[v].clear();
  }
  return around;
}

std::vector<double> corner_clearances(const TileMesh& tiles, const Array6& lower, double H_pin,
                                      Side side, int vertex, const std::vector<int>& around) {
  struct PinnedCorner {
    Vec3 corner, top;
  };
  const double sign = side == Side::front ? 1.0 : -1.0;
  const double face = side == Side::front ? 0.0 : -tiles.H_body;
  std::vector<PinnedCorner> corners;
  Vec3 normal = Vec3::Zero();
  for (int i : around) {
    const std::array<Vec2, 3> pin = pin_corners(tiles, i, side, lower.row(i).data());
    const RigidMotion& frame = tiles.frame[i];
    for (int t = 0; t < 3; ++t) {
      if (tiles.mesh.F(i, t) != vertex) continue;
      const std::array<Vec2, 3>& c = tiles.corners(i, side);
      const Vec2 a = c[next3(t)] - c[t], b = c[prev3(t)] - c[t];
      corners.push_back({frame(Vec3(c[t].x(), c[t].y(), face)),
                         frame(Vec3(pin[t].x(), pin[t].y(), face + sign * H_pin))});
      normal += sign * std::atan2(std::abs(wedge(a, b)), a.dot(b)) * tiles.normal(i);
    }
  }
  normal.normalize();
  double highest = -std::numeric_limits<double>::infinity();
  for (const PinnedCorner& c : corners) highest = std::max(highest, normal.dot(c.top));
  std::vector<double> out;
  for (const PinnedCorner& c : corners) out.push_back(highest - normal.dot(c.corner));
  return out;
}

double edge_clearance(double dihedral, Side side, double inset, double H_pin) {
  const double half = side == Side::front ? 0.5 * dihedral : -0.5 * dihedral;
  return H_pin * std::cos(half) - inset * std::sin(half);
}

}  // namespace curveups
