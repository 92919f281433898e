// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts without which a surface can't be flattened.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Edges (vertex pairs) to cut besides those with cut[edge] != 0, so that every piece has a boundary
// and no handle; holes stay. A closed piece gets a slit along the shortest path between two
// vertices about as far apart as can be. Handles are cut along short loops based at the boundary:
// the loops of the tree-cotree decomposition rooted at the whole boundary (J. Erickson, K.
// Whittlesey, "Greedy optimal homotopy and homology generators", SODA 2005) without which a handle
// would be left. No piece falls apart. cut: one entry per topology.edges, or empty.
Edges opening_cuts(const TriangleMesh& mesh, const MeshTopology& topology,
                   const std::vector<char>& cut);

}  // namespace curveups
