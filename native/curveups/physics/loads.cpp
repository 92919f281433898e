// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/loads.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <iterator>

#include "curveups/design/remote_overlaps.hpp"
#include "curveups/physics/membrane_domain.hpp"

namespace curveups {
namespace {

constexpr double newtons = 9.80665e-6;  // weight of a mm3 at 1 g / cm3

// A corner of a tile's body on the table.
struct Foot {
  int tile;
  Vec3 at;
};

std::vector<Foot> find_feet(const DesignGeometry& geometry, double L) {
  std::vector<Foot> corners, feet;
  double lowest = -1e300;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    for (const Vec3& p : tile_body(geometry.tiles, geometry.truncation, i).points) {
      corners.push_back({i, geometry.tiles.frame[i](p)});
      lowest = std::max(lowest, gravity_down.dot(corners.back().at));
    }
  }
  for (const Foot& corner : corners) {
    if (gravity_down.dot(corner.at) > lowest - L / 20) feet.push_back(corner);
  }
  return feet;
}

// Pushes n >= 0 of least square sum whose resultant is `total` through `middle` (N, any height):
// n = max(0, m . a) with a = (1, x, y) of each foot, m the minimum of a convex piecewise quadratic
// function, by Newton's method. Empty where middle lies beyond the feet.
Eigen::VectorXd least_pushes(const std::vector<Foot>& feet, double total, const Vec3& middle) {
  const Vec3 u = gravity_down.unitOrthogonal(), v = gravity_down.cross(u);
  Points3 a(static_cast<Eigen::Index>(feet.size()), 3);
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Vec3 arm = feet[f].at - middle;
    a.row(static_cast<Eigen::Index>(f)) << 1, u.dot(arm), v.dot(arm);
  }
  a.rightCols<2>() /= std::max(a.rightCols<2>().cwiseAbs().maxCoeff(), 1e-12);
  const Vec3 resultant(1, 0, 0);  // in units of total
  auto value = [&](const Vec3& m) {
    return 0.5 * (a * m).cwiseMax(0).squaredNorm() - resultant.dot(m);
  };
  Vec3 m(1.0 / static_cast<double>(feet.size()), 0, 0);
  for (int round = 0; round < 100; ++round) {
    const Eigen::VectorXd push = (a * m).cwiseMax(0);
    const Vec3 rest = a.transpose() * push - resultant;
    if (rest.norm() < 1e-12) return total * push;
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for (Eigen::Index f = 0; f < a.rows(); ++f) {
      if (push(f) > 0) hessian += a.row(f).transpose() * a.row(f);
    }
    const Vec3 step = -hessian.completeOrthogonalDecomposition().solve(rest);
    double length = 1;
    while (length > 1e-10 && value(m + length * step) > value(m) + 1e-4 * length * rest.dot(step)) {
      length /= 2;
    }
    m += length * step;
  }
  return {};
}

}  // namespace

Wrenches weights(const DesignGeometry& geometry, const Array6& q, const Parameters& p) {
  const TileMesh& tiles = geometry.tiles;
  Wrenches out = Wrenches::Zero(tiles.tile_count(), 6);
  if (p.gravity == "off") return out;
  std::vector<std::array<double, 3>> recess(tiles.tile_count(), {0, 0, 0});
  for (const Contact& contact : tiles.contacts) {
    for (int s = 0; s < 2; ++s) recess[contact.tile[s]][contact.side[s]] = wall_recess(p);
  }
  const Points3 centres = tile_centres(tiles);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    auto add = [&](double volume, const Vec3& place) {
      const Vec3 force = newtons * p.density * volume * gravity_down;
      const Vec3 arm = tiles.frame[i](place) - centres.row(i).transpose();
      out.row(i).head<3>() += force.transpose();
      out.row(i).tail<3>() += arm.cross(force).transpose();
    };
    const ConvexBody body = tile_body(tiles, geometry.truncation, i, recess[i]);
    add(volume(body), centroid(body));
    for (Side side : {Side::front, Side::back}) {
      const std::array<Vec2, 3> pin = pin_corners(tiles, i, side, q.row(i).data());
      const Vec2 middle = (pin[0] + pin[1] + pin[2]) / 3;
      const double level =
          pin_top_level(tiles, side, p.H_pin) + (side == Side::front ? -0.5 : 0.5) * p.H_pin;
      add(std::max(0.0, pin_area(tiles, i, side, q.row(i).data())) * p.H_pin,
          Vec3(middle.x(), middle.y(), level));
    }
  }
  return out;
}

std::vector<int> held_tiles(const DesignGeometry& geometry, const Parameters& parameters) {
  if (parameters.gravity != "held") return {};
  std::vector<int> named = listed_tiles(parameters.held_tiles);
  if (!named.empty()) return named;
  const TileMesh& tiles = geometry.tiles;
  const Eigen::VectorXd depth = tile_centres(tiles) * gravity_down;
  std::vector<int> held;
  for (const std::vector<int>& piece : pieces_of(tiles)) {
    const int lowest = *std::max_element(piece.begin(), piece.end(),
                                         [&](int a, int b) { return depth(a) < depth(b); });
    for (int i : piece) {
      if (share_vertex(tiles.mesh.F, i, lowest)) held.push_back(i);
    }
  }
  std::sort(held.begin(), held.end());
  return held;
}

Carried carry(const DesignGeometry& geometry, const Wrenches& weight,
              const Parameters& parameters) {
  const TileMesh& tiles = geometry.tiles;
  Carried out{Wrenches::Zero(tiles.tile_count(), 6), {}, {}};
  if (parameters.gravity == "off") return out;
  const Points3 centres = tile_centres(tiles);
  const std::vector<int> held = held_tiles(geometry, parameters);
  std::vector<Foot> all;
  if (parameters.gravity == "resting") all = find_feet(geometry, parameters.L);
  for (const std::vector<int>& piece : pieces_of(tiles)) {
    const auto inside = [&](int i) { return std::binary_search(piece.begin(), piece.end(), i); };
    if (std::any_of(held.begin(), held.end(), inside)) continue;
    std::vector<Foot> feet;
    std::copy_if(all.begin(), all.end(), std::back_inserter(feet),
                 [&](const Foot& foot) { return inside(foot.tile); });
    if (feet.empty()) {
      out.in_the_air.push_back(piece.front());
      continue;
    }
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int i : piece) {
      const Vec3 own = weight.row(i).head<3>(), centre = centres.row(i);
      force += own;
      torque += weight.row(i).tail<3>().transpose() + centre.cross(own);
    }
    const double total = force.norm();
    const Eigen::VectorXd push = least_pushes(feet, total, gravity_down.cross(torque) / total);
    if (push.size() == 0) out.tipping.push_back(piece.front());
    for (Eigen::Index f = 0; f < push.size(); ++f) {
      const Foot& foot = feet[static_cast<std::size_t>(f)];
      const Vec3 up = -push(f) * gravity_down, arm = foot.at - centres.row(foot.tile).transpose();
      out.table.row(foot.tile).head<3>() += up.transpose();
      out.table.row(foot.tile).tail<3>() += arm.cross(up).transpose();
    }
  }
  return out;
}

}  // namespace curveups
