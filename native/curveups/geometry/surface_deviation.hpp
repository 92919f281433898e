// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances between two surfaces, by samples: each face is halved along its longest edge until no
// edge is longer than a step, and the distance is taken at the parts' centroids and at vertices.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Step over the mean edge of the coarser of two meshes. A largest distance falls short by at most
// the distance from a point to the nearest sample, two thirds of the step.
inline constexpr double sample_step = 1.0 / 8;

// Largest distance of samples of the mesh's faces from the surface, mm. Throws Cancelled.
double largest_distance(const TriangleMesh& mesh, const TriangleMesh& surface);

struct Deviation {
  double mean = 0, rms = 0, max = 0;  // distance of the mesh from the target, by area, mm
  double hausdorff = 0;               // largest distance in both directions
};
// Throws Cancelled.
Deviation surface_deviation(const TriangleMesh& mesh, const TriangleMesh& target);

}  // namespace curveups
