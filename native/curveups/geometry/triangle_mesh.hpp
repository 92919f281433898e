// SPDX-License-Identifier: LGPL-2.1-or-later
// An oriented triangle mesh and its edges.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// N x 3 vertices in mm, M x 3 faces, counter-clockwise seen from the front.
struct TriangleMesh {
  Points3 V;
  Triangles F;
};

// Mesh without the vertices that no face uses.
struct UsedPart {
  TriangleMesh mesh;        // vertices keep their order
  std::vector<int> number;  // per given vertex its new number, -1: removed
};
UsedPart used_part(const Points3& V, Triangles F);

// Key of an edge in either direction.
inline std::uint64_t edge_key(int a, int b) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32) |
         static_cast<std::uint32_t>(std::max(a, b));
}

// Copies pairs of vertices in any container into rows.
template <class Pairs>
Edges rows_of(const Pairs& pairs) {
  Edges out(static_cast<Eigen::Index>(pairs.size()), 2);
  Eigen::Index row = 0;
  for (const auto& [a, b] : pairs) out.row(row++) << a, b;
  return out;
}

// Edge t of a face joins its corners t and t + 1.
struct MeshEdge {
  int v[2];     // as its first face runs along it
  int face[2];  // the second is -1 on the boundary; face[0] < face[1] otherwise
  int side[2];  // which edge (0 to 2) of those faces it is
  bool boundary() const { return face[1] < 0; }
};

struct MeshTopology {
  std::vector<MeshEdge> edges;  // in the order in which the faces' edges first name them
  Triangles edge_of;            // M x 3: the edge at each side of each face
  Triangles neighbour;          // M x 3: the face across each side, -1 on the boundary
};

// Throws TopologyError, naming the faces, for a face that uses a vertex twice, an edge of more than
// two faces, and an edge with two faces in the same direction.
MeshTopology build_topology(const Triangles& F);

// Marks the vertices of boundary edges.
std::vector<char> boundary_vertices(const MeshTopology& topology, Eigen::Index vertex_count);

// Boundary loops: vertices with the surface on their left. Throws TopologyError where the boundary
// touches itself in a vertex.
std::vector<std::vector<int>> boundary_loops(const MeshTopology& topology);

// Handles (genus) of a connected surface with that many boundary loops.
int handle_count(const MeshTopology& topology, int loop_count);

// Component of each face, from 0 in the order of the lowest face. Edges with `joined` connect
// faces; an empty `joined` stands for all interior edges.
std::vector<int> face_components(const MeshTopology& topology, const std::vector<char>& joined);

// Lengths of the edges, mm.
std::vector<double> edge_lengths(const TriangleMesh& mesh, const MeshTopology& topology);
// Length of a closed line of edges, mm.
double loop_length(const Points3& V, const std::vector<int>& loop);
// Mean length of edges, mm; 0 without faces. Throws what build_topology throws.
double mean_edge_length(const TriangleMesh& mesh);
Vec3 face_area_vector(const TriangleMesh& mesh, int face);  // normal times area
double surface_area(const TriangleMesh& mesh);              // mm2

}  // namespace curveups
