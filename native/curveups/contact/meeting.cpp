// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/meeting.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "curveups/contact/motion_energy.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

// The least distance between a face and the corner furthest behind it.
double thickness(const RigidBody& body) {
  double least = std::numeric_limits<double>::infinity();
  for (const BodySurface& face : body.faces) {
    double deepest = 0;
    for (const BodySurface& other : body.faces) {
      for (const Vec3& p : other.outline) {
        deepest = std::max(deepest, face.offset - face.normal.dot(p));
      }
    }
    // A face alone, such as the ground's, has no other side.
    if (deepest > 1e-9) least = std::min(least, deepest);
  }
  return least;
}

// Height of the arc on which a point turns by this rotation.
double sag(const Eigen::Matrix3d& turn, double radius) {
  return radius * (1 - std::sqrt(std::clamp(0.25 * (1 + turn.trace()), 0.0, 1.0)));
}

// Height of the arc on which an origin moves along a screw.
double screw_bulge(const Eigen::Matrix3d& turn, double shift) {
  const double angle = std::acos(std::clamp(0.5 * (turn.trace() - 1), -1.0, 1.0));
  return 0.5 * shift * std::tan(0.25 * angle);
}

struct Way {
  double shift = 0;   // mm, motion of the origin
  double chord = 0;   // of a point as it turns, over its distance from the origin
  double radius = 0;  // of the corners about the origin, mm
  double thin = 0;    // the body's thickness, mm
};

// Largest motion of corners of `b` in coordinates of `a`, arcs beside their chords included.
double relative_motion(const RigidBody& b, const RigidMotion& a0, const RigidMotion& b0,
                       const RigidMotion& a1, const RigidMotion& b1) {
  double furthest = 0, radius = 0;
  for (const BodySurface& face : b.faces) {
    for (const Vec3& p : face.outline) {
      const Vec3 start = seen_from(a0, b0, p);
      furthest = std::max(furthest, (seen_from(a1, b1, p) - start).norm());
      radius = std::max({radius, start.norm(), p.norm()});
    }
  }
  const Eigen::Matrix3d before = a0.R.transpose() * b0.R, after = a1.R.transpose() * b1.R;
  return furthest + sag(after * before.transpose(), radius);
}

}  // namespace

bool could_pass(const std::vector<RigidBody>& bodies, const Poses& from, const Poses& to) {
  std::vector<int> solid;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].is_point()) solid.push_back(static_cast<int>(i));
  }
  const int count = static_cast<int>(solid.size());
  std::vector<Eigen::AlignedBox3d> boxes(count);
  std::vector<Way> way(count);
  parallel_for(count, [&](int k) {
    const RigidBody& body = bodies[solid[k]];
    const RigidMotion &first = from[solid[k]], &last = to[solid[k]];
    double radius = 0;
    for (const BodySurface& face : body.faces) {
      for (const Vec3& p : face.outline) {
        boxes[k].extend(first(p));
        boxes[k].extend(last(p));
        radius = std::max(radius, p.norm());
      }
    }
    const Eigen::Matrix3d turn = last.R * first.R.transpose();
    const double shift = (last.t - first.t).norm();
    const double bulge = sag(turn, radius) + screw_bulge(turn, shift);
    boxes[k] = grown(boxes[k], bulge);
    way[k] = {shift, std::sqrt(std::max(0.0, 3 - turn.trace())), radius, thickness(body)};
  });
  const auto near = overlapping_boxes(boxes);
  std::atomic<bool> passes = false;
  parallel_for(static_cast<int>(near.size()), [&](int k) {
    if (passes) return;
    auto [a, b] = near[k];
    if (!bodies[solid[a]].can_touch(bodies[solid[b]])) return;
    // A fixed body may be large, such as the ground: corners of the other move.
    if (bodies[solid[b]].fixed) std::swap(a, b);
    const double most = 0.5 * std::min(way[a].thin, way[b].thin);
    // Chords are longer than their arcs are high: most pairs move less than this.
    const double far = (from[solid[b]].t - from[solid[a]].t).norm() + way[b].radius;
    if (way[a].shift + way[b].shift + 2 * far * (way[a].chord + way[b].chord) <= most) return;
    if (relative_motion(bodies[solid[b]], from[solid[a]], from[solid[b]], to[solid[a]],
                        to[solid[b]]) > most) {
      passes = true;
    }
  });
  return passes;
}

}  // namespace curveups
