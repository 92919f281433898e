// SPDX-License-Identifier: LGPL-2.1-or-later
// Graded triangulation of a plane polygon by constrained Delaunay refinement (CGAL's implementation
// of J. Shewchuk, "Delaunay refinement algorithms for triangular mesh generation", 2002) with a
// size and angle criterion of our own. Boundary edges are kept as they are, so that polygons which
// share a side can be meshed independently of one another.
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

// boundary: a simple polygon, counter-clockwise, at least 3 points. size(p): the longest edge
// wanted at p. Points are inserted until no triangle has a longer edge at its centroid, or an angle
// below 20.6 degrees, unless the point would fall into the diametral circle of a boundary edge: the
// angles of the boundary itself, and edges much shorter than their neighbours, limit what can be
// had. Throws InvalidInput where the boundary is not simple or not counter-clockwise, or a point is
// not finite.
PlanarMesh mesh_polygon(const std::vector<Vec2>& boundary,
                        const std::function<double(const Vec2&)>& size);

// The same of the region between closed lines of edges, pairs of points: all of the plane that they
// enclose, but for what holds one of `holes`, up to the lines around that. Points that no edge has
// are none of the region's corners. Throws InvalidInput where two points are the same, or edges
// cross or touch besides at their ends.
PlanarMesh mesh_region(const std::vector<Vec2>& points,
                       const std::vector<std::array<int, 2>>& edges, const std::vector<Vec2>& holes,
                       const std::function<double(const Vec2&)>& size);

// Whether the closed polygon is counter-clockwise and neither crosses nor touches itself.
bool is_simple_polygon(const std::vector<Vec2>& boundary);

}  // namespace curveups
