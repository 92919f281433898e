// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes of a surface, filled and faired (P. Liepa, "Filling holes in meshes", SGP 2003; CGAL's
// implementation).
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// The boundary loops of a manifold that are shorter than `longest` (mm), but for the longest one of
// each component; as boundary_loops gives them.
std::vector<std::vector<int>> small_holes(const TriangleMesh& mesh, double longest);

// Fills these boundary loops with triangles of about the size of those around. Returns how many
// could be; the vertices that were there keep place and number. Throws Cancelled between holes.
int fill_holes(TriangleMesh& mesh, const std::vector<std::vector<int>>& holes);

}  // namespace curveups
