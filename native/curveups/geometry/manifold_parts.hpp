// SPDX-License-Identifier: LGPL-2.1-or-later
// Surfaces taken apart where they are no manifolds.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Whether every edge has one face or two that run along it in opposite directions, and every vertex
// one fan of faces.
bool is_manifold(const TriangleMesh& mesh);

// Duplicates vertices until it is one (CGAL's orient_polygon_soup, which turns faces, too), and
// moves each duplicate by a thousandth of its shortest edge towards its faces, so that they are not
// merged again. Returns how many there are.
int part_manifolds(TriangleMesh& mesh);

}  // namespace curveups
