// SPDX-License-Identifier: LGPL-2.1-or-later
// From what files hold (triangle soups, slivers, mixed orientations) to a mesh.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct CleanMesh {
  TriangleMesh mesh;
  std::vector<std::string> notes;  // one per kind of repair, with its count
};

// Merges vertices nearer than 1e-7 of the size of the surface, removes faces that thereby use a
// vertex twice, faces without area (a neighbour is split at the vertex that lay on its edge, so
// that no gap opens), doubled faces and unused vertices, and turns faces so that neighbours agree,
// with the larger area of each component left as it was. What can't be repaired stays: check_mesh
// tells. Throws Cancelled, and InvalidInput for an index out of range, for coordinates beyond
// tolerance::largest_coordinate and where all vertices lie in one point.
CleanMesh clean_mesh(const TriangleMesh& soup);

// Rows of faces whose three vertices an earlier one has, in any order; ascending. Faces that use a
// vertex twice are left out. Throws Cancelled.
std::vector<int> repeated_faces(const Eigen::Ref<const Triangles>& F, int vertex_count);

// A vertex twice, or corners on a line to 1e-10 of the longest edge.
bool has_no_area(const TriangleMesh& mesh, int face);

}  // namespace curveups
