// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace curveups::test {

TriangleMesh lifted_patch(int rows, int columns, double L,
                          const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  const int across = columns + 1;
  mesh.V.resize((rows + 1) * across, 3);
  mesh.F.resize(2 * rows * columns, 3);
  const double h = L * std::sqrt(0.75);
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      const double x = L * (c + (r % 2 == 0 ? 0.0 : 0.5)) - 0.5 * columns * L,
                   y = h * (r - 0.5 * rows);
      mesh.V.row(r * across + c) << x, y, height(x, y);
    }
  }
  int f = 0;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const int a = r * across + c, b = a + 1, d = a + across, e = d + 1;
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

TriangleMesh lifted_patch(int n, double L, const std::function<double(double, double)>& height) {
  return lifted_patch(n, n, L, height);
}

TriangleMesh flat_patch(int n, double L) {
  return lifted_patch(n, L, [](double, double) { return 0.0; });
}

TriangleMesh cone(int n, double L) {
  return lifted_patch(n, L, [](double x, double y) { return -0.8 * std::hypot(x, y); });
}

TriangleMesh dome(int n, double L, double radius) {
  return lifted_patch(n, L, [=](double x, double y) {
    return std::sqrt(std::max(0.0, radius * radius - x * x - y * y)) - radius;
  });
}

TriangleMesh saddle(int n, double L, double radius) {
  return lifted_patch(n, L, [=](double x, double y) { return (x * x - y * y) / (2 * radius); });
}

TriangleMesh ripples(int n, double L) {
  return lifted_patch(
      n, L, [](double x, double y) { return 3 * std::sin(0.25 * x) * std::cos(0.2 * y); });
}

TriangleMesh single_triangle(double L) {
  TriangleMesh mesh;
  mesh.V.resize(3, 3);
  mesh.V << 0, 0, 0, L, 0, 0, 0.5 * L, L * std::sqrt(0.75), 0;
  mesh.F.resize(1, 3);
  mesh.F << 0, 1, 2;
  return mesh;
}

TriangleMesh hinge(double dihedral, double L) {
  const double h = L * std::sqrt(0.75), c = std::cos(0.5 * dihedral), s = std::sin(0.5 * dihedral);
  TriangleMesh mesh;
  mesh.V.resize(4, 3);
  mesh.V << 0, 0, 0, 0, L, 0, -h * c, 0.5 * L, -h * s, h * c, 0.5 * L, -h * s;
  mesh.F.resize(2, 3);
  mesh.F << 0, 1, 2, 1, 0, 3;
  return mesh;
}

TriangleMesh grid(int columns, int rows, const std::function<Vec3(double u, double v)>& place) {
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

TriangleMesh flat_square(int n, double size) {
  return grid(n, n, [=](double u, double v) { return Vec3(u * size, v * size, 0); });
}

TriangleMesh half_sphere(int n, double radius) {
  // The square |x| + |y| <= 1 as a grid turned by 45 degrees, lifted to the octahedron's upper
  // half.
  return grid(2 * n, 2 * n, [=](double u, double v) {
    const double s = 2 * u - 1, t = 2 * v - 1;
    const double x = 0.5 * (s - t), y = 0.5 * (s + t);
    const Vec3 p(x, y, 1 - std::abs(x) - std::abs(y));
    return Vec3(radius * p.normalized());
  });
}

TriangleMesh sphere(int n, double radius) {
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

TriangleMesh tube(int around, int along, double radius, double height) {
  TriangleMesh mesh = grid(around, along, [=](double u, double v) {
    return Vec3(radius * std::cos(2 * M_PI * u), radius * std::sin(2 * M_PI * u), height * v);
  });
  for (int i = 0; i < mesh.F.size(); ++i) {  // the last column is the first
    int& v = mesh.F.data()[i];
    if (v % (around + 1) == around) v -= around;
  }
  return mesh;
}

TriangleMesh torus(int around, int along) {
  TriangleMesh mesh = grid(around, along, [](double u, double v) {
    const double a = 2 * M_PI * u, b = 2 * M_PI * v, r = 30 + 12 * std::cos(b);
    return Vec3(r * std::cos(a), r * std::sin(a), 12 * std::sin(b));
  });
  for (int i = 0; i < mesh.F.size(); ++i) {  // opposite rims lie on one another
    int& v = mesh.F.data()[i];
    v = v / (around + 1) % along * (around + 1) + v % (around + 1) % around;
  }
  return mesh;
}

TriangleMesh hexagon(int rings, const std::function<double(double, double)>& height) {
  TriangleMesh mesh;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> index(2 * rings + 1, std::vector<int>(2 * rings + 1, -1));
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      if (std::abs(i + j) > rings) continue;
      const double x = 7 * (i + 0.5 * j), y = 7 * std::sqrt(0.75) * j;
      index[i + rings][j + rings] = static_cast<int>(points.size());
      points.push_back({x, y, height(x, y)});
    }
  }
  std::vector<std::array<int, 3>> faces;
  auto at = [&](int i, int j) {
    return std::abs(i) > rings || std::abs(j) > rings || std::abs(i + j) > rings
               ? -1
               : index[i + rings][j + rings];
  };
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j - 1);
      if (a >= 0 && b >= 0 && c >= 0) faces.push_back({a, b, c});
      if (a >= 0 && d >= 0 && b >= 0) faces.push_back({a, d, b});
    }
  }
  mesh.V.resize(points.size(), 3);
  for (std::size_t v = 0; v < points.size(); ++v) mesh.V.row(v) = points[v].transpose();
  mesh.F.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
    mesh.F.row(f) << faces[f][0], faces[f][1], faces[f][2];
  return mesh;
}

double cap_height(double x, double y) { return std::sqrt(48.0 * 48 - x * x - y * y) - 48; }

double saddle_height(double x, double y) { return (x * x - y * y) / 90; }

}  // namespace curveups::test
