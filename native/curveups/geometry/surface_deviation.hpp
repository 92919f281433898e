// SPDX-License-Identifier: LGPL-2.1-or-later
// How far surfaces are from one another: the largest distance to a bound that is proven, by heights
// (height_bound.hpp) and, where these prove nothing, by branch and bound over triangles (after M.
// Tang, M. Lee, Y. J. Kim, "Interactive Hausdorff distance computation for general polygonal
// models", 2009); mean and RMS by quadrature.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// By how much a largest distance may fall short of the true one, mm.
inline constexpr double distance_tolerance = 0.005;

struct LargestDistance {
  double low = 0;   // of a point of the mesh, mm
  double high = 0;  // no point of the mesh is farther; at most low + distance_tolerance
};

// From any point of the mesh's faces to the surface; vertices without a face don't count. The same
// whatever the threads. Throws what ClosestPoints throws of the surface, Cancelled.
LargestDistance largest_distance(const TriangleMesh& mesh, const TriangleMesh& surface);

struct Deviation {
  double mean = 0, rms = 0;  // of the mesh from the target, by area, mm
  double max = 0;            // the same, the largest, within distance_tolerance
  double hausdorff = 0;      // the larger of both directions' largest, likewise
};
// Throws what ClosestPoints throws of either, Cancelled.
Deviation surface_deviation(const TriangleMesh& mesh, const TriangleMesh& target);

}  // namespace curveups
