// SPDX-License-Identifier: LGPL-2.1-or-later
// Places the bumps of an interface.
#pragma once

#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// Centres of three bumps in the region (convex, counter-clockwise), from left to right: two in one
// row of constant y and one in another, or, where those would stand nearer than `spacing` or on a
// line, at corners of the region. Empty where three do not fit. A plane on three points does not
// rock.
std::vector<Vec2> bump_pattern(const Polygon& region, double spacing);

}  // namespace curveups
