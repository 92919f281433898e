// SPDX-License-Identifier: LGPL-2.1-or-later
// Small surfaces. Lengths in mm; normals up or outward.
#pragma once

#include <functional>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::test {

// A triangulated patch of about rows x columns edges of length L over the plane, lifted to
// z = height(x, y); rows of near equilateral triangles, normals up.
TriangleMesh lifted_patch(int rows, int columns, double L,
                          const std::function<double(double, double)>& height);
TriangleMesh lifted_patch(int n, double L, const std::function<double(double, double)>& height);

TriangleMesh flat_patch(int n = 6, double L = 7);

// A cone of slope 0.8 over a patch: its tip is a sharp fold.
TriangleMesh cone(int n = 6, double L = 7);

TriangleMesh dome(int n = 8, double L = 7, double radius = 40);

TriangleMesh saddle(int n = 8, double L = 7, double radius = 50);

TriangleMesh ripples(int n = 8, double L = 7);

TriangleMesh single_triangle(double L = 7);

// Two triangles that share an edge along y, folded down by `fold` (rad, convex positive).
TriangleMesh hinge(double dihedral, double L = 7);

// (columns + 1) x (rows + 1) points of the unit square put through `place`, two faces per cell,
// counter-clockwise in the square.
TriangleMesh grid(int columns, int rows, const std::function<Vec3(double u, double v)>& place);

TriangleMesh flat_square(int n, double size);

// The part of an n-divided octahedral sphere with z >= 0: one boundary loop.
TriangleMesh half_sphere(int n, double radius);

// Two half-spheres glued along the equator: closed, normals outward.
TriangleMesh sphere(int n, double radius);

// A tube along z with both ends open.
TriangleMesh tube(int around, int along, double radius, double height);

// A closed torus of radii 30 and 12; some vertices are unused.
TriangleMesh torus(int around, int along);

// A hexagonal patch of `rings` rings of equilateral triangles with edges of about 7 mm, raised by
// `height(x, y)`.
TriangleMesh hexagon(int rings, const std::function<double(double, double)>& height);

double cap_height(double x, double y);

double saddle_height(double x, double y);

}  // namespace curveups::test
