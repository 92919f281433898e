// SPDX-License-Identifier: LGPL-2.1-or-later
// Second half of remeshing: springs move vertices along the surface until edges are about equally
// long, and no face becomes a sliver.
#pragma once

#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/isotropic_mesh.hpp"

namespace curveups {

// Points on a surface and the surface's unit normals there; zero where it has none (on creases).
struct SurfacePoints {
  Points3 V;
  Points3 normal;
};

// Quality of the triangle a, b, c on a surface whose normals at the corners have the sum `normal`:
// twice the area seen along it over the square of the longest edge. sqrt(3)/2 for an equilateral
// triangle, 0 for a flat one, negative for one that is turned over.
double soundness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);
double soundness(const SurfacePoints& points, const Triangles& F, int face);

// Quality below which faces are slivers.
inline constexpr double least_soundness = 0.05;

// Faces that are slivers or turned over, ascending.
std::vector<int> unsound_faces(const SurfacePoints& points, const Triangles& F);

// Undoes moves of vertices from `before` to `after` that would make a face a sliver or turn it
// over. Moves that mend an unsound face stay. Every face of `after` is then sound or as sound as
// before.
void undo_unsound_moves(const Triangles& F, const SurfacePoints& before, SurfacePoints& after);

// Flips edges that are no features towards valence 6 (4 on the boundary) where that spoils no
// angle. kept: per face, those that stay as they are; empty: none. Returns how many.
int flip_towards_regular(IsotropicMesh& mesh, const std::vector<char>& kept = {});

// `passes` rounds of springs of rest length `length` that move the vertices which are neither fixed
// nor on the boundary or a feature, and put them back onto `surface`; flips in between, if asked
// for. undo_unsound_moves checks every move. Returns the vertices with the surface's normals.
SurfacePoints even_edges(IsotropicMesh& mesh, double length, int passes,
                         const ClosestPoints& surface, bool flips = true);

}  // namespace curveups
