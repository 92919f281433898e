// SPDX-License-Identifier: LGPL-2.1-or-later
// Second half of remeshing: vertices slide along the surface until all edges are about equally
// long.
#pragma once

#include "curveups/geometry/face_guard.hpp"
#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

// Flips edges that are no features towards valence 6 (4 on the boundary) where that spoils no
// angle. Returns how many.
int flip_towards_regular(IsotropicMesh& mesh);

// `passes` rounds of springs of rest length `length` that move the vertices which are neither fixed
// nor on the boundary or a feature, and put them back onto `surface`; flips in between. No move
// spoils a face (face_guard.hpp). Returns the vertices with the surface's normals.
SurfacePoints even_edges(IsotropicMesh& mesh, double length, int passes,
                         const ClosestPoints& surface);

}  // namespace curveups
