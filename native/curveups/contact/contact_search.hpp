// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact points of convex bodies. In each pair that is near, the face that separates the two best
// and the face of the other body opposite to it touch. The corners of the intersection of their
// outlines, clipped in the plane of the first, are points of either body against the plane of the
// other; tips that stand on the faces take their place. (C. Ericson, Real-Time Collision Detection,
// 2005: separating axes and face clipping.)
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "curveups/contact/rigid_body.hpp"

namespace curveups {

// A point of one body of a pair that may press on a face of the other.
struct Touch {
  int of;  // body of the pair with the point, 0 or 1
  Vec3 point;
  Vec3 normal;    // face of the other body, in that body's coordinates
  double offset;  // the point presses where normal . y < offset, y in the other's coordinates
  Eigen::Matrix<double, 3, 2> tangents;
  double stiffness, tangent_stiffness;  // N / mm

  // Friction's history: stretch of the tangential spring (mm) before the present step, when y had
  // the tangential coordinates `reference`.
  Vec2 stretch = Vec2::Zero(), reference = Vec2::Zero();
  Vec2 built = Vec2::Zero();  // tangential coordinates when outlines were clipped
  double cap = 0;             // largest friction force, N
  double slip = 0;            // mm, total

  double gap(const Vec3& y) const { return normal.dot(y) - offset; }
  double push(const Vec3& y) const { return stiffness * std::max(0.0, -gap(y)); }
  // Stretch of the tangential spring, if it did not slip.
  Vec2 reach(const Vec3& y) const { return stretch + tangents.transpose() * y - reference; }
};

// Pair of bodies that touch, or nearly do.
struct TouchingPair {
  std::array<int, 2> body;  // ascending
  std::array<int, 2> face;
  std::vector<Touch> touches;
  int coupling = -1;  // number among the coupled pairs (ContactEnergy)
};

struct SearchOptions {
  double reach = 0.5;  // mm: faces further apart than this do not touch
  double keep = 0.1;   // mm: motion along their faces after which corners are clipped anew
  // Stiffness of every pair whose outlines touch, N / mm; 0: by its material and common area.
  double pair_stiffness = 0;
  // mm: faces that touched go on to touch until others part the bodies better by more than this;
  // with none, bodies that touch in a corner could change faces for ever.
  double face_margin = 0;
};

// Tangential stiffness over normal stiffness, after Mindlin: 2 (1 - nu) / (2 - nu) for a Poisson
// ratio of 0.35.
inline constexpr double tangent_ratio = 0.79;

// Touching pairs in ascending order. before: pairs of an earlier state; their points stay where
// bodies have moved little, else new points take friction's history from the nearest on the same
// faces.
std::vector<TouchingPair> find_touching(const std::vector<RigidBody>& bodies, const Poses& poses,
                                        const SearchOptions& options,
                                        const std::vector<TouchingPair>& before);

}  // namespace curveups
