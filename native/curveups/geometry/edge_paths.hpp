// SPDX-License-Identifier: LGPL-2.1-or-later
// Paths along the edges of a mesh, for cuts that are drawn as polylines.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// The vertices of the shortest edge path through the vertices nearest to each of the points (P x
// 3), in their order; a point alone gives one vertex. Throws InvalidInput (no points, points or
// vertices not finite) and TopologyError where no path of edges joins two of them.
std::vector<int> shortest_edge_path(const TriangleMesh& mesh, const Points3& points);

}  // namespace curveups
