// SPDX-License-Identifier: LGPL-2.1-or-later
// Places the bumps of an interface.
#pragma once

#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// `count` centres in the room (convex, counter-clockwise) in two rows of constant y, or, where
// those would stand nearer than `spacing` or on a line, three at corners of the room. From left to
// right; empty where not even three fit. Precondition: count >= 3.
std::vector<Vec2> bump_pattern(const Polygon& region, int count, double spacing);

}  // namespace curveups
