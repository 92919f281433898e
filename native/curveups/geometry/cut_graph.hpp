// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts that open a surface far enough to be flattened at all.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Edges (vertex pairs) to cut besides those with cut[edge] != 0, so that every piece has a boundary
// and no handle; holes stay. Empty where nothing is needed. A closed piece gets a slit along the
// shortest path between two vertices that are about as far apart as can be. Handles are cut along
// short loops based at the boundary: of the tree-cotree decomposition (J. Erickson, K. Whittlesey,
// "Greedy optimal homotopy and homology generators", SODA 2005), with the whole boundary as its
// root, those without which a handle would be left. No piece falls apart. cut: one entry per
// topology.edges, or empty.
Edges opening_cuts(const TriangleMesh& mesh, const MeshTopology& topology,
                   const std::vector<char>& cut);

}  // namespace curveups
