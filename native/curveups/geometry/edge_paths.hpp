// SPDX-License-Identifier: LGPL-2.1-or-later
// Paths along the edges of a mesh: cuts that are drawn as polylines, and cuts that are proposed.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Shortest paths from the nearest of some vertices (E. Dijkstra, 1959). Of equally short ones those
// that reach their vertices from lower numbers.
struct PathTree {
  std::vector<double> distance;  // infinite where no path leads
  std::vector<int> before;  // the vertex before on the path, -1 at sources and where none leads

  std::vector<int> path_to(int vertex) const;  // from a source, both included
};

// length: one per topology.edges, not negative; an edge of infinite length is not used.
PathTree shortest_paths(const MeshTopology& topology, const std::vector<double>& length,
                        int vertex_count, const std::vector<int>& sources);

// The vertices of the shortest edge path through the vertices nearest to each of the points (P x
// 3), in their order; a point alone gives one vertex. Throws InvalidInput (no points, points or
// vertices not finite) and TopologyError where no path of edges joins two of them.
std::vector<int> shortest_edge_path(const TriangleMesh& mesh, const Points3& points);

}  // namespace curveups
