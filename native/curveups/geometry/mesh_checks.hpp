// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds the places of a surface that can't become tiles.
#pragma once

#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Findings in this order; the first group (arrays that mean nothing) and the second (no manifold)
// end the checks.
//   empty, index-out-of-range, not-finite;
//   degenerate-faces, duplicate-faces, non-manifold-edges, inconsistent-orientation, one-sided,
//   non-manifold-vertices, boundary-touches-itself;
//   closed (unless cuts are given), self-intersections, huge-coordinates, too-small, too-large,
//   and as information (no error) components.
// Figures: "count", and "faces" or "vertices", the rows concerned.
// L: edge length of the tiles, mm. without_crossings: skips the search for self-intersections.
// Throws Cancelled.
std::vector<Finding> check_mesh(const TriangleMesh& mesh, double L, bool cuts_given,
                                bool without_crossings = false);

// Faces that run through others, ascending. Precondition: the first two groups of check_mesh.
// Throws Cancelled.
std::vector<int> self_intersecting_faces(const TriangleMesh& mesh);

}  // namespace curveups
