// SPDX-License-Identifier: LGPL-2.1-or-later
// Pairs of boxes that overlap.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// low, high: n x 3 corners of boxes (z = 0 throughout for flat ones). Returns all pairs i < j whose
// boxes overlap or touch, in ascending order.
std::vector<std::array<int, 2>> overlapping_boxes(const Points3& low, const Points3& high);

}  // namespace curveups
