// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/spring_forces.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/layout/layout_figures.hpp"

namespace curveups {
namespace {

// Times f_min: springs spread less than exact forces do.
constexpr double caution = 5;

double pin_edge(const TileMesh& tiles, int tile, int t, Side side, const Array6& q) {
  const std::array<Vec2, 3> pin = pin_corners(tiles, tile, side, q.row(tile).data());
  return (pin[next3(t)] - pin[t]).norm();
}

}  // namespace

Eigen::VectorXd spring_forces(const DesignGeometry& geometry, const Parameters& p,
                              const FlatPoses& poses, const Array6& q) {
  const TileMesh& tiles = geometry.tiles;
  const Eigen::VectorXd slack = spring_ratios(geometry, p, poses, q);
  Eigen::VectorXd out(static_cast<Eigen::Index>(tiles.contacts.size()));
  for (Eigen::Index k = 0; k < out.size(); ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    double pull[2];
    for (Side side : {Side::front, Side::back}) {
      const int s = static_cast<int>(side);
      const double modulus = side == Side::front ? p.shear_modulus_front : p.shear_modulus_back;
      const double thickness = side == Side::front ? p.thickness_front : p.thickness_back;
      const double width = 0.5 * (pin_edge(tiles, contact.tile[0], contact.side[0], side, q) +
                                  pin_edge(tiles, contact.tile[1], contact.side[1], side, q));
      // Plane stress of an incompressible sheet, per width before it was stretched.
      const double along = 1 / std::max(1e-3, slack[2 * k + s]), across = p.tau;
      const double stress = modulus * (along - 1 / (along * along * along * across * across));
      pull[s] = std::max(0.0, stress) * thickness * width / p.tau;
    }
    out[k] = 0.25 * (pull[0] + pull[1]);
  }
  return out;
}

std::vector<int> weak_by_springs(const Eigen::VectorXd& forces, double f_min_ratio) {
  std::vector<int> out;
  if (forces.size() == 0) return out;
  const double least = caution * f_min_ratio * std::max(0.0, forces.mean());
  for (Eigen::Index k = 0; k < forces.size(); ++k) {
    if (!(forces[k] > least)) out.push_back(static_cast<int>(k));
  }
  return out;
}

}  // namespace curveups
