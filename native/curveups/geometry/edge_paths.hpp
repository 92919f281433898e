// SPDX-License-Identifier: LGPL-2.1-or-later
// Shortest paths along the edges of a mesh.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Paths from the nearest source (E. Dijkstra, 1959). Ties: paths reach vertices from lower numbers.
struct PathTree {
  std::vector<double> distance;  // infinite where no path leads
  std::vector<int> before;       // previous vertex on the path, -1 at sources and where none leads

  std::vector<int> path_to(int vertex) const;  // from a source, both included
};

// length: one per topology.edges, not negative; edges of infinite length are not used.
PathTree shortest_paths(const MeshTopology& topology, const std::vector<double>& length,
                        int vertex_count, const std::vector<int>& sources);

// Vertices of the shortest edge path through the vertices nearest to the points (P x 3), in their
// order. mesh: finite vertices, at least one face. Throws InvalidInput where there are no points,
// TopologyError where no path of edges joins two of them.
std::vector<int> shortest_edge_path(const TriangleMesh& mesh, const Points3& points);

}  // namespace curveups
