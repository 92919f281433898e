// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangulation of a plane region without new points: constrained Delaunay (CGAL).
#pragma once

#include <array>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// The region that an odd number of the loops encloses. Loops are closed polygons of indices into
// `points`, at least three each, that neither cross nor touch; their direction does not matter.
// Returns counter-clockwise triangles over the same points; every edge of a loop is an edge of
// exactly one of them. Throws TopologyError for loops that cross or touch, or points that coincide.
std::vector<std::array<int, 3>> triangulate_region(const std::vector<Vec2>& points,
                                                   const std::vector<std::vector<int>>& loops);

// A polygon in space, in the plane that its Newell normal is perpendicular to; its triangles run
// round as it does. Empty where it crosses or touches itself there, or has no area.
std::vector<std::array<int, 3>> triangulate_polygon(const Points3& corners);

}  // namespace curveups
