// SPDX-License-Identifier: LGPL-2.1-or-later
// A plane region with holes as polygons without holes, over the same points.
#pragma once

#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// The region that an odd number of the loops encloses (see triangulate_region, whose preconditions
// and errors hold here), divided along edges of its constrained Delaunay triangulation. Returns
// counter-clockwise polygons of at most `most_corners` (three or more) points, none of which visits
// a point twice: they have no holes and touch themselves nowhere. Every edge of a loop is an edge
// of exactly one polygon, every other edge belongs to two, in opposite directions. Edges over
// which a triangle is low go first: needles vanish, and short edges between neighbouring loops
// stay.
std::vector<std::vector<int>> divide_region(const std::vector<Vec2>& points,
                                            const std::vector<std::vector<int>>& loops,
                                            int most_corners);

}  // namespace curveups
