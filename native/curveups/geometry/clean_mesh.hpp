// SPDX-License-Identifier: LGPL-2.1-or-later
// Makes a mesh of the contents of files: triangle soups, slivers, mixed orientations.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct CleanMesh {
  TriangleMesh mesh;
  std::vector<std::string> notes;  // repairs with their counts
};

// Merges vertices nearer than 1e-7 of the size of the surface, removes faces that thereby use a
// vertex twice, faces without area (a neighbour is split at the vertex that lay on its edge, so
// that no gap opens), doubled faces and unused vertices, and turns faces so that neighbours agree,
// with the larger area of each component left as it was. Parts that touch in a vertex alone get one
// each. check_mesh reports the rest. Throws
// Cancelled, and InvalidInput for an index out of range, for coordinates beyond
// tolerance::largest_coordinate and where all vertices lie in one point.
CleanMesh clean_mesh(const TriangleMesh& soup);

// Moves the vertices from number `first` on, copies of others, by a thousandth of their shortest
// edge towards their faces, so that they are not merged with these again.
void draw_apart(TriangleMesh& mesh, int first);

// True for a face that uses a vertex twice, or whose corners lie on a line to 1e-10 of its longest
// edge.
bool has_no_area(const TriangleMesh& mesh, int face);

}  // namespace curveups
