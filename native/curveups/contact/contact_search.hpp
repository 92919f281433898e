// SPDX-License-Identifier: LGPL-2.1-or-later
// Where convex bodies touch. Of each pair that is near, the face that separates the two best and
// the face of the other that looks at it touch; what their outlines have in common, clipped in the
// plane of the first, is where. Its corners are points of either body against the plane of the
// other (both directions); where tips stand on the faces, these are. (C. Ericson, Real-Time
// Collision Detection, 2005: separating axes and face clipping.)
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "curveups/contact/rigid_body.hpp"

namespace curveups {

// A point of one body of a pair that may press on a face of the other.
struct Touch {
  int of;  // which of the pair has the point, 0 or 1
  Vec3 point;
  Vec3 normal;    // of the other's face, in the other's coordinates
  double offset;  // the point presses where normal . y < offset, y as the other sees it
  Eigen::Matrix<double, 3, 2> tangents;
  double stiffness, tangent_stiffness;  // N / mm

  // Friction's history: the stretch of the tangential spring (mm) when y's tangential coordinates
  // were `reference`, before the present step.
  Vec2 stretch = Vec2::Zero(), reference = Vec2::Zero();
  Vec2 built = Vec2::Zero();  // the tangential coordinates when outlines were clipped
  double cap = 0;             // largest friction force, N
  double slip = 0;            // mm in all

  double gap(const Vec3& y) const { return normal.dot(y) - offset; }
  double push(const Vec3& y) const { return stiffness * std::max(0.0, -gap(y)); }
  // Stretch of the tangential spring, if it did not slip.
  Vec2 reach(const Vec3& y) const { return stretch + tangents.transpose() * y - reference; }
};

// Of a pair of bodies that touch, or nearly do.
struct TouchingPair {
  std::array<int, 2> body;  // ascending
  std::array<int, 2> face;
  std::vector<Touch> touches;
  int coupling = -1;  // its number among the pairs that are coupled (ContactEnergy)
};

struct SearchOptions {
  double reach = 0.5;  // faces further apart than this do not touch, mm
  // Corners are clipped anew where bodies moved along their faces by more than this, mm.
  double keep = 0.1;
  // N / mm, of every pair whose outlines touch; 0: as the materials are, by the area that touches.
  double pair_stiffness = 0;
  // Faces that touched stay those that touch until others part the bodies better by more than this,
  // mm: without it, bodies that touch in a corner could change faces for ever.
  double face_margin = 0;
};

// Tangential stiffness over normal stiffness, after Mindlin: 2 (1 - nu) / (2 - nu) for a Poisson
// ratio of 0.35.
inline constexpr double tangent_ratio = 0.79;

// Pairs in ascending order. before: pairs of an earlier state, whose memory of friction goes on: as
// they are where they are still good, else from the nearest point on the same faces.
std::vector<TouchingPair> find_touching(const std::vector<RigidBody>& bodies, const Poses& poses,
                                        const SearchOptions& options,
                                        const std::vector<TouchingPair>& before);

}  // namespace curveups
