// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangulation of a plane region without new points: constrained Delaunay (CGAL).
#pragma once

#include <array>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// Triangulates the region that an odd number of the loops encloses. Loops are closed polygons of
// indices into `points`, at least three each, that neither cross nor touch, in either direction.
// Returns counter-clockwise triangles over the same points; every edge of a loop is an edge of
// exactly one triangle. Throws TopologyError for loops that cross or touch, or points that
// coincide.
std::vector<std::array<int, 3>> triangulate_region(const std::vector<Vec2>& points,
                                                   const std::vector<std::vector<int>>& loops);

// Triangulates a polygon in space (N x 3 corners) in the plane perpendicular to its Newell normal;
// triangles have the polygon's direction. Empty where it crosses or touches itself, or has no area.
std::vector<std::array<int, 3>> triangulate_polygon(const Points3& corners);

}  // namespace curveups
