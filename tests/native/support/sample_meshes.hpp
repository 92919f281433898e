// SPDX-License-Identifier: LGPL-2.1-or-later
// Small meshes that tests of several rooms share.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::test {

// A triangulated patch of about n x n edges of length L over the plane, lifted to z = height(x, y);
// rows of near equilateral triangles, normals up.
inline TriangleMesh lifted_patch(int n, double L,
                                 const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  mesh.V.resize((n + 1) * (n + 1), 3);
  mesh.F.resize(2 * n * n, 3);
  const double h = L * std::sqrt(0.75);
  for (int r = 0; r <= n; ++r) {
    for (int c = 0; c <= n; ++c) {
      const double x = L * (c + (r % 2 == 0 ? 0.0 : 0.5)) - 0.5 * n * L, y = h * (r - 0.5 * n);
      mesh.V.row(r * (n + 1) + c) << x, y, height(x, y);
    }
  }
  int f = 0;
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      const int a = r * (n + 1) + c, b = a + 1, d = a + n + 1, e = d + 1;
      if (r % 2 == 0) {
        mesh.F.row(f++) << a, b, d;
        mesh.F.row(f++) << b, e, d;
      } else {
        mesh.F.row(f++) << a, e, d;
        mesh.F.row(f++) << a, b, e;
      }
    }
  }
  return mesh;
}

inline TriangleMesh flat_patch(int n = 6, double L = 7) {
  return lifted_patch(n, L, [](double, double) { return 0.0; });
}

// A cone of slope 0.8 over a patch: its tip is a sharp fold.
inline TriangleMesh cone(int n = 6, double L = 7) {
  return lifted_patch(n, L, [](double x, double y) { return -0.8 * std::hypot(x, y); });
}

inline TriangleMesh dome(int n = 8, double L = 7, double radius = 40) {
  return lifted_patch(n, L, [=](double x, double y) {
    return std::sqrt(std::max(0.0, radius * radius - x * x - y * y)) - radius;
  });
}

inline TriangleMesh saddle(int n = 8, double L = 7, double radius = 50) {
  return lifted_patch(n, L, [=](double x, double y) { return (x * x - y * y) / (2 * radius); });
}

inline TriangleMesh ripples(int n = 8, double L = 7) {
  return lifted_patch(
      n, L, [](double x, double y) { return 3 * std::sin(0.25 * x) * std::cos(0.2 * y); });
}

inline TriangleMesh single_triangle(double L = 7) {
  TriangleMesh mesh;
  mesh.V.resize(3, 3);
  mesh.V << 0, 0, 0, L, 0, 0, 0.5 * L, L * std::sqrt(0.75), 0;
  mesh.F.resize(1, 3);
  mesh.F << 0, 1, 2;
  return mesh;
}

// Two triangles that share an edge along y, folded down by `fold` (rad, convex positive).
inline TriangleMesh hinge(double fold, double L = 7) {
  const double h = L * std::sqrt(0.75), c = std::cos(0.5 * fold), s = std::sin(0.5 * fold);
  TriangleMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 0, 0, L, 0, -h * c, 0.5 * L, -h * s, h * c, 0.5 * L, -h * s;
  mesh.F.resize(2, 3);
  mesh.F << 0, 1, 2, 1, 0, 3;
  return mesh;
}

}  // namespace curveups::test
