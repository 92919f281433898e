// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/loads.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "curveups/bodies/joint_holes.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/physics/membrane_domain.hpp"

namespace curveups {
namespace {

constexpr double standard_gravity = 9.80665;  // m / s2
constexpr double kilograms = 1e-6;            // of a mm3 at 1 g / cm3
constexpr double membrane_density = 0.93;  // g / cm3: natural rubber (thermopedia.com/content/1105)

class Weights {
 public:
  Weights(const TileMesh& tiles, const Vec3& down)
      : down_(down), centres_(tile_centres(tiles)), out_(Wrenches::Zero(tiles.tile_count(), 6)) {}

  // mm3 of g / cm3 at a place (world).
  void add(int tile, double volume, double density, const Vec3& place) {
    const Vec3 force = down_ * (density * kilograms * volume * standard_gravity);
    out_.row(tile).head<3>() += force.transpose();
    out_.row(tile).tail<3>() += (place - centres_.row(tile).transpose()).cross(force).transpose();
  }
  const Wrenches& result() const { return out_; }

 private:
  Vec3 down_;
  Points3 centres_;
  Wrenches out_;
};

double cap_volume(const WallCap& cap) {
  return M_PI / 6 * cap.height * (3 * cap.radius * cap.radius + cap.height * cap.height);
}

double area_of(const MembranePatch& patch, const Points2& corners) {
  double twice = 0;
  for (std::size_t k = 0; k < patch.corners.size(); ++k) {
    const Vec2 a = corners.row(patch.corners[k]),
               b = corners.row(patch.corners[(k + 1) % patch.corners.size()]);
    twice += wedge(a, b);
  }
  return 0.5 * twice;
}

// Of one side's membrane, at the middle of the pin tops.
void add_membrane(const TileMesh& tiles, const FlatPoses& poses, const Array6& q,
                  const Parameters& p, Side side, Weights& out) {
  const double rest = side == Side::front ? p.thickness_front : p.thickness_back;
  const double thickness = rest / (p.tau * p.tau);  // where it is stretched, in the layout
  const Points3 tops = actuated_pin_corners(tiles, q, side, p.H_pin);
  auto add = [&](int tile, double area) {
    const Vec3 middle = tops.middleRows<3>(3 * tile).colwise().mean().transpose();
    out.add(tile, area * thickness, membrane_density, middle);
  };
  for (int i = 0; i < tiles.tile_count(); ++i) {
    add(i, std::max(0.0, pin_area(tiles, i, side, q.row(i).data())));
  }
  const Points2 flat = flat_pin_corners(tiles, poses, q, side);
  for (const MembranePatch& patch : make_membrane_domain(tiles, side).patches) {
    const std::vector<int> around = tiles_of(patch);
    const double share = area_of(patch, flat) / static_cast<double>(around.size());
    for (int tile : around) add(tile, share);
  }
}

// A corner of a tile's body on the table.
struct Foot {
  int tile;
  Vec3 at;
};

std::vector<Foot> find_feet(const DesignGeometry& geometry, const Vec3& down, double L) {
  std::vector<Foot> corners, feet;
  double lowest = -1e300;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    for (const Vec3& p : tile_body(geometry.tiles, geometry.truncation, i).points) {
      corners.push_back({i, geometry.tiles.frame[i](p)});
      lowest = std::max(lowest, down.dot(corners.back().at));
    }
  }
  for (const Foot& corner : corners) {
    if (down.dot(corner.at) > lowest - L / 20) feet.push_back(corner);
  }
  return feet;
}

// The pushes n >= 0 of least square sum whose resultant is `total` through `middle` (N, any height
// along down): n = max(0, m . a) with a = (1, x, y) of each foot, m the minimum of a convex
// piecewise quadratic function, found by Newton's method. Empty where middle lies beyond the feet.
Eigen::VectorXd least_pushes(const std::vector<Foot>& feet, const Vec3& down, double total,
                             const Vec3& middle) {
  const Vec3 u = down.unitOrthogonal(), v = down.cross(u);
  Points3 a(static_cast<Eigen::Index>(feet.size()), 3);
  for (std::size_t f = 0; f < feet.size(); ++f) {
    const Vec3 arm = feet[f].at - middle;
    a.row(static_cast<Eigen::Index>(f)) << 1, u.dot(arm), v.dot(arm);
  }
  a.rightCols<2>() /= std::max(a.rightCols<2>().cwiseAbs().maxCoeff(), 1e-12);
  const Vec3 asked(1, 0, 0);  // in units of total
  auto value = [&](const Vec3& m) {
    return 0.5 * (a * m).cwiseMax(0).squaredNorm() - asked.dot(m);
  };
  Vec3 m(1.0 / static_cast<double>(feet.size()), 0, 0);
  for (int round = 0; round < 100; ++round) {
    const Eigen::VectorXd push = (a * m).cwiseMax(0);
    const Vec3 rest = a.transpose() * push - asked;
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

Wrenches weights(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                 const Parameters& p) {
  const TileMesh& tiles = geometry.tiles;
  Weights out(tiles, gravity_down);
  if (p.gravity == "off") return Wrenches::Zero(tiles.tile_count(), 6);
  const BumpPlan plan = plan_bumps(geometry, poses, p);
  const JointHoles joints = plan_joint_holes(geometry, plan, q, p);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const RigidMotion& frame = tiles.frame[i];
    auto add = [&](double volume, const Vec3& place) {
      out.add(i, volume, p.density, frame(place));
    };
    add(volume(plan.body[i]), centroid(plan.body[i]));
    for (const WallCap& cap : plan.of_tile[i]) {
      add((cap.bump ? 1 : -1) * cap_volume(cap), cap.centre);
    }
    for (const JointHole& hole : joints.of_tile[i]) {
      add(-M_PI * joints.radius * joints.radius * tiles.H_body,
          Vec3(hole.axis.x(), hole.axis.y(), -0.5 * tiles.H_body));
    }
    for (Side side : {Side::front, Side::back}) {
      const std::array<Vec2, 3> pin = pin_corners(tiles, i, side, q.row(i).data());
      const Vec2 middle = (pin[0] + pin[1] + pin[2]) / 3;
      const double level =
          pin_top_level(tiles, side, p.H_pin) + (side == Side::front ? -0.5 : 0.5) * p.H_pin;
      add(std::max(0.0, pin_area(tiles, i, side, q.row(i).data())) * p.H_pin,
          Vec3(middle.x(), middle.y(), level));
    }
  }
  for (Side side : {Side::front, Side::back}) add_membrane(tiles, poses, q, p, side, out);
  return out.result();
}

std::vector<int> held_tiles(const DesignGeometry& geometry, const Parameters& parameters) {
  if (parameters.gravity != "held") return {};
  std::vector<int> named = listed_tiles(parameters.held_tiles);
  if (!named.empty()) return named;
  const TileMesh& tiles = geometry.tiles;
  const Vec3 down = gravity_down;
  const Points3 centres = tile_centres(tiles);
  const std::vector<int> piece = pieces_of_faces(tiles.topology, tiles.cut);
  std::vector<int> lowest(piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1,
                          -1);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    int& best = lowest[piece[i]];
    if (best < 0 || down.dot(centres.row(i)) > down.dot(centres.row(best))) best = i;
  }
  std::vector<int> held;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const auto own = tiles.mesh.F.row(i), grip = tiles.mesh.F.row(lowest[piece[i]]);
    bool around = false;
    for (int t = 0; t < 3; ++t) around = around || (grip.array() == own(t)).any();
    if (around) held.push_back(i);
  }
  return held;
}

Carried carry(const DesignGeometry& geometry, const Wrenches& weight,
              const Parameters& parameters) {
  const TileMesh& tiles = geometry.tiles;
  const int count = tiles.tile_count();
  Carried out{Wrenches::Zero(count, 6), {}, {}};
  if (parameters.gravity == "off" || count == 0) return out;
  const Vec3 down = gravity_down;
  const Points3 centres = tile_centres(tiles);
  const std::vector<int> piece = pieces_of_faces(tiles.topology, tiles.cut);
  const int pieces = *std::max_element(piece.begin(), piece.end()) + 1;
  std::vector<int> first(pieces, -1);
  std::vector<std::vector<Foot>> feet(pieces);
  for (int i = count - 1; i >= 0; --i) first[piece[i]] = i;
  if (parameters.gravity == "resting") {
    for (const Foot& foot : find_feet(geometry, down, parameters.L)) {
      feet[piece[foot.tile]].push_back(foot);
    }
  }
  std::vector<char> held(pieces, 0);
  for (int tile : held_tiles(geometry, parameters)) held[piece[tile]] = 1;
  for (int k = 0; k < pieces; ++k) {
    if (held[k] != 0) continue;
    if (feet[k].empty()) {
      out.in_the_air.push_back(first[k]);
      continue;
    }
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
      if (piece[i] != k) continue;
      const Vec3 own = weight.row(i).head<3>(), centre = centres.row(i);
      force += own;
      torque += weight.row(i).tail<3>().transpose() + centre.cross(own);
    }
    const double total = force.norm();
    const Eigen::VectorXd push = least_pushes(feet[k], down, total, down.cross(torque) / total);
    if (push.size() == 0) out.tipping.push_back(first[k]);
    for (Eigen::Index f = 0; f < push.size(); ++f) {
      const Foot& foot = feet[k][f];
      const Vec3 up = -push(f) * down, arm = foot.at - centres.row(foot.tile).transpose();
      out.table.row(foot.tile).head<3>() += up.transpose();
      out.table.row(foot.tile).tail<3>() += arm.cross(up).transpose();
    }
  }
  return out;
}

}  // namespace curveups
