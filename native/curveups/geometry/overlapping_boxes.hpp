// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of boxes that overlap.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// Returns all pairs i < j whose boxes overlap or touch, in ascending order. Flat boxes have z = 0.
std::vector<std::array<int, 2>> overlapping_boxes(const std::vector<Eigen::AlignedBox3d>& boxes);

// Box with its faces moved out by `margin`.
inline Eigen::AlignedBox3d grown(const Eigen::AlignedBox3d& box, double margin) {
  return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

}  // namespace curveups
