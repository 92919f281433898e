// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds the places of a surface that can't become tiles.
#pragma once

#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Findings in this order; after the first group (arrays that mean nothing) and after the second (no
// manifold) no further ones are looked for.
//   empty, index-out-of-range, not-finite;
//   degenerate-faces, duplicate-faces, non-manifold-edges, inconsistent-orientation, one-sided,
//   non-manifold-vertices, boundary-touches-itself;
//   closed (unless cuts are given), self-intersections, huge-coordinates, too-small, too-large,
//   and as information (no error) components.
// Their figures: "count", and "faces" or "vertices", the rows concerned.
// L: the edge length the tiles will have, mm. without_crossings: no face is known to run through
// another, which is then not looked for again. Throws Cancelled.
std::vector<Finding> check_mesh(const TriangleMesh& mesh, double L, bool cuts_given,
                                bool without_crossings = false);

// Pairs of faces that run through one another, each face once, ascending. The mesh must have passed
// the first two groups of check_mesh. Throws Cancelled.
std::vector<int> self_intersecting_faces(const TriangleMesh& mesh);

}  // namespace curveups
