// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/joint_holes.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/tolerances.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {
namespace {

constexpr double two_holes = 12.0;  // mm of edge

// Places along an edge, mm from its start in the direction of its tile.
struct Range {
  double low, high;
  bool empty() const { return !(low <= high); }
};

class Planner {
 public:
  Planner(const DesignGeometry& geometry, const BumpPlan& bumps, const Array6& q,
          const Parameters& parameters)
      : tiles_(geometry.tiles), bumps_(bumps), q_(q), p_(parameters) {
    plan_.radius = 0.5 * joint_hole;
    plan_.of_tile.resize(tiles_.tile_count());
  }

  JointHoles run() {
    if (p_.joint != "holes") return std::move(plan_);
    plan_.joints = find_joints(tiles_);
    for (int k = 0; k < static_cast<int>(plan_.joints.size()); ++k) {
      if (!place(k)) plan_.closed.push_back(k);
    }
    return std::move(plan_);
  }

 private:
  // Axis in tile s of the joint; `along`: in the direction of its first tile.
  Vec2 axis(const Joint& joint, int s, double along) const {
    const int tile = joint.tile[s], t = joint.side[s];
    const std::array<Vec2, 3>& corner = tiles_.front[tile];
    const Vec2 direction = (corner[next3(t)] - corner[t]).normalized();
    const double own = s == 0 ? along : tiles_.length(tile, t) - along;
    return corner[t] + own * direction + joint_depth(tiles_, p_, tile, t) * tiles_.inward(tile, t);
  }

  // True if pins begin far enough behind the hole.
  bool clear_of_pins(int tile, int t) const {
    for (Side side : {Side::front, Side::back}) {
      const double least = joint_inset(tiles_, p_, tile, side, t);
      if (q_(tile, inset_index(side, t)) < least - tolerance::constraint) return false;
    }
    return true;
  }

  double deepest_hollow(int tile, int wall) const {
    double depth = 0;
    for (const WallCap& cap : bumps_.of_tile[tile]) {
      if (cap.wall == wall && !cap.bump) depth = std::max(depth, cap.height);
    }
    return depth;
  }

  // Free places along tile s of the joint: p_floor between the hole and each face of the body but
  // front and back, at the height where they are nearest.
  Range free_range(const Joint& joint, int s) const {
    const int tile = joint.tile[s];
    const double length = tiles_.length(tile, joint.side[s]);
    Range range{0, length};
    const Vec2 start = axis(joint, s, 0), step = (axis(joint, s, length) - start) / length;
    for (const BodyFace& face : bumps_.body[tile].faces) {
      if (face.tag == body_tag::front || face.tag == body_tag::back) continue;
      const bool wall = face.tag < body_tag::cut;
      const Vec2 level = face.plane.normal.head<2>();
      const double keep = p_.p_floor + plan_.radius * level.norm() +
                          std::max(0.0, -face.plane.normal.z() * tiles_.H_body) +
                          (wall ? deepest_hollow(tile, face.tag - body_tag::wall) : 0.0);
      const double left = face.plane.offset - level.dot(start) - keep + tolerance::constraint;
      const double slope = level.dot(step);
      if (slope > tolerance::constraint) {
        range.high = std::min(range.high, left / slope);
      } else if (slope < -tolerance::constraint) {
        range.low = std::max(range.low, left / slope);
      } else if (left < 0) {
        return {1, 0};
      }
    }
    return range;
  }

  bool clear_of_holes(const Joint& joint, const std::vector<double>& places) const {
    for (int s = 0; s < 2; ++s) {
      for (double along : places) {
        for (const JointHole& other : plan_.of_tile[joint.tile[s]]) {
          if ((other.axis - axis(joint, s, along)).norm() < apart()) return false;
        }
      }
    }
    return true;
  }

  double apart() const { return 2 * plan_.radius + p_.p_floor; }  // axes of two holes

  bool place(int k) {
    const Joint& joint = plan_.joints[k];
    for (int s = 0; s < 2; ++s) {
      if (!clear_of_pins(joint.tile[s], joint.side[s])) return false;
    }
    const Range a = free_range(joint, 0), b = free_range(joint, 1);
    const Range both{std::max(a.low, b.low), std::min(a.high, b.high)};
    if (both.empty()) return false;
    const double length = tiles_.length(joint.tile[0], joint.side[0]);
    std::vector<double> places{std::clamp(0.5 * length, both.low, both.high)};
    if (length >= two_holes) {
      const double first = std::clamp(0.25 * length, both.low, both.high),
                   second = std::clamp(0.75 * length, both.low, both.high);
      if (second - first >= apart()) places = {first, second};
    }
    if (!clear_of_holes(joint, places)) return false;
    for (int s = 0; s < 2; ++s) {
      for (double along : places) {
        plan_.of_tile[joint.tile[s]].push_back({axis(joint, s, along), k});
      }
    }
    return true;
  }

  const TileMesh& tiles_;
  const BumpPlan& bumps_;
  const Array6& q_;
  const Parameters& p_;
  JointHoles plan_;
};

}  // namespace

JointHoles plan_joint_holes(const DesignGeometry& geometry, const BumpPlan& bumps, const Array6& q,
                            const Parameters& parameters) {
  return Planner(geometry, bumps, q, parameters).run();
}

void bore(PrintBody& body, const std::vector<JointHole>& holes, double radius, double H_body,
          const RigidMotion& motion) {
  for (const JointHole& hole : holes) {
    const Vec3 front(hole.axis.x(), hole.axis.y(), 0), back(hole.axis.x(), hole.axis.y(), -H_body);
    BodyLoop at_front, at_back;
    at_front.circle = static_cast<int>(body.circles.size());
    at_back.circle = at_front.circle + 1;
    const Vec3 along = motion.R * Vec3::UnitZ();
    body.circles.push_back({motion(front), along, radius});
    body.circles.push_back({motion(back), along, radius});
    body.cylinders.push_back({at_back.circle, at_front.circle, false});
    for (PlanarFace& face : body.faces) {
      if (face.role == FaceRole::front) face.inner.push_back(at_front);
      if (face.role == FaceRole::back) face.inner.push_back(at_back);
    }
  }
}

}  // namespace curveups
