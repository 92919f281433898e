// SPDX-License-Identifier: LGPL-2.1-or-later
// Small surfaces that the tests of this room share.
#pragma once

#include <cmath>
#include <functional>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::samples {

inline constexpr double pi = 3.14159265358979323846;

// (columns + 1) x (rows + 1) points of the unit square put through `place`, two faces per cell,
// counter-clockwise in the square.
inline TriangleMesh grid(int columns, int rows,
                         const std::function<Vec3(double u, double v)>& place) {
  TriangleMesh mesh;
  mesh.V.resize((columns + 1) * (rows + 1), 3);
  mesh.F.resize(2 * columns * rows, 3);
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.V.row(j * (columns + 1) + i) = place(double(i) / columns, double(j) / rows);
    }
  }
  int f = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      if ((i + j) % 2 == 0) {
        mesh.F.row(f++) << a, b, d;
        mesh.F.row(f++) << a, d, c;
      } else {
        mesh.F.row(f++) << a, b, c;
        mesh.F.row(f++) << b, d, c;
      }
    }
  }
  return mesh;
}

inline TriangleMesh flat_square(int n, double size) {
  return grid(n, n, [=](double u, double v) { return Vec3(u * size, v * size, 0); });
}

// A unit octahedron, its faces divided n x n and pushed to the sphere: closed, normals outward.
inline TriangleMesh sphere(int n, double radius);

// The part of an n-divided octahedral sphere with z >= 0: one boundary loop.
inline TriangleMesh half_sphere(int n, double radius) {
  // The square |x| + |y| <= 1 as a grid turned by 45 degrees, lifted to the octahedron's upper
  // half.
  return grid(2 * n, 2 * n, [=](double u, double v) {
    const double s = 2 * u - 1, t = 2 * v - 1;
    const double x = 0.5 * (s - t), y = 0.5 * (s + t);
    const Vec3 p(x, y, 1 - std::abs(x) - std::abs(y));
    return Vec3(radius * p.normalized());
  });
}

// Two half-spheres glued along the equator.
inline TriangleMesh sphere(int n, double radius) {
  const TriangleMesh half = half_sphere(n, radius);
  const int count = static_cast<int>(half.V.rows());
  std::vector<int> mirror(count);
  int next = count;
  for (int v = 0; v < count; ++v) {
    mirror[v] = std::abs(half.V(v, 2)) < 1e-9 * radius ? v : next++;
  }
  TriangleMesh mesh;
  mesh.V.resize(next, 3);
  mesh.F.resize(2 * half.F.rows(), 3);
  for (int v = 0; v < count; ++v) {
    mesh.V.row(mirror[v]) << half.V(v, 0), half.V(v, 1), -half.V(v, 2);
    mesh.V.row(v) = half.V.row(v);
  }
  for (int f = 0; f < half.F.rows(); ++f) {
    mesh.F.row(2 * f) = half.F.row(f);
    mesh.F.row(2 * f + 1) << mirror[half.F(f, 0)], mirror[half.F(f, 2)], mirror[half.F(f, 1)];
  }
  return mesh;
}

// A tube along z with both ends open.
inline TriangleMesh tube(int around, int along, double radius, double height) {
  TriangleMesh mesh = grid(around, along, [=](double u, double v) {
    return Vec3(radius * std::cos(2 * pi * u), radius * std::sin(2 * pi * u), height * v);
  });
  for (int i = 0; i < mesh.F.size(); ++i) {  // the last column is the first
    int& v = mesh.F.data()[i];
    if (v % (around + 1) == around) v -= around;
  }
  return mesh;
}

}  // namespace curveups::samples
