// SPDX-License-Identifier: LGPL-2.1-or-later
// Scans of millions of facets made as coarse as remeshing needs them.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Collapses vertices into neighbours where the edges that arise are no longer than `length` (mm)
// and no face turns by more than 45 degrees or becomes a sliver; in rounds of vertices whose faces
// do not touch. Vertices of the boundary and those with kept[v] != 0 (empty: none) stay, and with
// them number and shape of boundaries and the topology. Deterministic, in time linear in the faces
// times the logarithm of the factor. Edges of other than two faces count as boundary. Throws
// Cancelled.
UsedPart coarsen(const TriangleMesh& mesh, double length, const std::vector<char>& kept);

}  // namespace curveups
