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

// How far a point can be from the chord of the arc on which it turns by this rotation.
double sag(const Eigen::Matrix3d& turn, double radius) {
  return radius * (1 - std::sqrt(std::clamp(0.25 * (1 + turn.trace()), 0.0, 1.0)));
}

// How far corners of `b` move as `a` sees them, and arcs beside their chords.
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
  return furthest + sag(a1.R * a0.R.transpose(), radius) + sag(b1.R * b0.R.transpose(), radius);
}

}  // namespace

bool could_pass(const std::vector<RigidBody>& bodies, const Poses& from, const Poses& to) {
  std::vector<int> solid;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].faces.empty()) solid.push_back(static_cast<int>(i));
  }
  const int count = static_cast<int>(solid.size());
  Points3 low(count, 3), high(count, 3);
  std::vector<double> thin(count);
  parallel_ranges(count, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const RigidMotion &first = from[solid[k]], &last = to[solid[k]];
      Box box;
      double radius = 0;
      for (const BodySurface& face : bodies[solid[k]].faces) {
        for (const Vec3& p : face.outline) {
          box.add(first(p));
          box.add(last(p));
          radius = std::max(radius, p.norm());
        }
      }
      const double bulge = sag(last.R * first.R.transpose(), radius);
      low.row(k) = (box.low.array() - bulge).matrix().transpose();
      high.row(k) = (box.high.array() + bulge).matrix().transpose();
      thin[k] = thickness(bodies[solid[k]]);
    }
  });
  const auto near = overlapping_boxes(low, high);
  std::atomic<bool> found = false;
  parallel_ranges(static_cast<int>(near.size()), [&](int begin, int end) {
    for (int k = begin; k < end && !found; ++k) {
      const int i = solid[near[k][0]], j = solid[near[k][1]];
      if (!bodies[i].can_touch(bodies[j])) continue;
      // What stands still may be large, such as the ground: corners of the other move.
      const auto [a, b] = bodies[j].fixed ? std::pair(j, i) : std::pair(i, j);
      if (relative_motion(bodies[b], from[a], from[b], to[a], to[b]) >
          0.5 * std::min(thin[near[k][0]], thin[near[k][1]])) {
        found = true;
      }
    }
  });
  return found;
}

}  // namespace curveups
