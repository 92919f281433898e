// SPDX-License-Identifier: LGPL-2.1-or-later
// Pose of a body in space.
#pragma once

#include "curveups/core/types.hpp"

namespace curveups {

// Map from a body's own coordinates to the world. Columns of R are the images of the axes.
struct RigidMotion {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Vec3 t = Vec3::Zero();
  Vec3 operator()(const Vec3& p) const { return R * p + t; }
  // Inverse map.
  Vec3 to_own(const Vec3& p) const { return R.transpose() * (p - t); }
};

}  // namespace curveups
