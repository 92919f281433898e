// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded triangulation of a plane polygon by constrained Delaunay refinement (CGAL's implementation
// of J. Shewchuk, "Delaunay refinement algorithms for triangular mesh generation", 2002). Boundary
// edges are not divided, so that polygons which share a side can be meshed independently.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

struct PlanarMesh {
  std::vector<Vec2> points;                   // the boundary first, in its order
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
};

// boundary: a simple polygon, counter-clockwise, at least 3 points. size(p): the longest edge at p.
// Points are inserted until no triangle has an edge longer than the size at its centroid, or an
// angle below 20.6 degrees, unless a point would fall into the diametral circle of a boundary edge:
// angles of the boundary and edges much shorter than their neighbours limit both. Throws
// InvalidInput unless is_simple_polygon(boundary).
PlanarMesh mesh_polygon(const std::vector<Vec2>& boundary,
                        const std::function<double(const Vec2&)>& size);

// True for a counter-clockwise closed polygon that neither crosses nor touches itself.
bool is_simple_polygon(const std::vector<Vec2>& boundary);

}  // namespace curveups
