// SPDX-License-Identifier: LGPL-2.1-or-later
// Rigid registration of a scan, without an initial guess: distances of its points to the tangent
// planes at their closest points (Y. Chen and G. Medioni, 1992), minimized over SE(3) by
// Gauss-Newton steps with a robust loss.
#pragma once

#include "curveups/core/rigid_motion.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct Registration {
  RigidMotion pose;       // from the scan's coordinates to the surface's
  double noise = 0;       // standard deviation of distances, mm, from their median
  double loss_scale = 0;  // mm: Tukey's loss is constant beyond this distance
  // Standard deviations of the pose about and along the surface's axes, for independent noise:
  // radians, and mm of the scan's middle. NaN where the points leave a direction free.
  Vec3 rotation_deviation, translation_deviation;
  int other_turns = 0;  // at least so many other poses fit as well
};

// points: n x 3, 12 or more, mm. tile: size of tiles, mm; poses that differ by less count as one.
// Outliers are allowed, and the scan may cover a part of the surface.
Registration register_scan(const Points3& points, const TriangleMesh& surface, double tile);

// points: n x 3, mm, each at its row of targets but for noise; outliers are allowed.
Registration register_markers(const Points3& points, const Points3& targets);

}  // namespace curveups
