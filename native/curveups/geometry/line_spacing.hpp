// SPDX-License-Identifier: LGPL-2.1-or-later
// Evenly spaced vertices on the boundary and the feature lines of a mesh.
#pragma once

#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

// The mesh with vertices inserted into its boundary edges and `features` (vertex pairs; their faces
// are split into fans), so that each stretch between two corners (turns above `corner_angle`, rad,
// and ends of features), or each whole loop, is divided into equal arcs of about `length`; a loop
// into three at least. These vertices and the corners are marked as fixed, all others are free.
// Pairs that are no edge are left out. Where `reach` (mm) is not 0, lines must turn that much
// between points this far on either side, too, and of corners nearer than that to one another the
// sharpest is one: otherwise every tooth of a ragged line is.
IsotropicMesh space_lines(const TriangleMesh& mesh, const Edges& features, double length,
                          double corner_angle, double reach = 0);

}  // namespace curveups
