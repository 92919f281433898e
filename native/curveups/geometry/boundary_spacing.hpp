// SPDX-License-Identifier: LGPL-2.1-or-later
// Evenly spaced vertices on the boundary of a mesh.
#pragma once

#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

// The mesh with vertices inserted into its boundary edges (their faces are split into fans), so
// that each stretch of boundary between two corners (turns above `corner_angle`, rad), or each
// whole loop, is divided into equal arcs of about `length`; a loop into three at least. These
// vertices and the corners are marked as fixed, all others are free.
IsotropicMesh space_boundary(const TriangleMesh& mesh, double length, double corner_angle);

}  // namespace curveups
