// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that stay faces while their vertices slide along a surface.
#pragma once

#include "curveups/geometry/closest_points.hpp"

namespace curveups {

// Points on a surface and the surface's unit normals there; zero where it has none (on creases).
struct SurfacePoints {
  Points3 V;
  Points3 normal;
};

// Of the triangle a, b, c on a surface whose normals at the corners have the sum `normal`: twice
// the area seen along it over the square of the longest edge. sqrt(3)/2 for an equilateral
// triangle, 0 for a flat one, negative for one that is turned over.
double soundness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);
double soundness(const SurfacePoints& points, const Triangles& F, int face);

// Faces below this are slivers.
inline constexpr double least_soundness = 0.05;

// Faces that are slivers or turned over, ascending.
std::vector<int> unsound_faces(const SurfacePoints& points, const Triangles& F);

// Cuts the moves of vertices from `before` to `after` short where they would make a face a sliver
// or turn it over: such a move is halved, at last left out. Moves that mend an unsound face stay.
// Every face of `after` is then sound or as sound as before. Vertices that did not move are left
// where they are, the others end on `surface`.
void cut_short(const Triangles& F, const SurfacePoints& before, SurfacePoints& after,
               const ClosestPoints& surface);

}  // namespace curveups
