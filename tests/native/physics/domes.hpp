// SPDX-License-Identifier: LGPL-2.1-or-later
// Small designs with a spread-out flat layout, so that physics is tested without an optimiser.
#pragma once

#include <cmath>
#include <functional>

#include "curveups/design/design.hpp"

namespace curveups::testing {

// A hexagonal patch of `rings` rings of equilateral triangles with edges of about 7 mm, raised by
// `height(x, y)`.
inline TriangleMesh hexagon(int rings, const std::function<double(double, double)>& height) {
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

inline double sphere_cap(double x, double y) { return std::sqrt(48.0 * 48 - x * x - y * y) - 48; }
inline double saddle(double x, double y) { return (x * x - y * y) / 90; }

// Every tile placed rigidly over its projection to the xy plane, which is spread by `spread`.
inline Design spread_design(const TriangleMesh& mesh, double spread, double inset) {
  Design design;
  design.name = "test";
  design.parameters.L = 7;
  design.mesh = mesh;
  design.cuts.resize(0, 2);
  const TileMesh tiles = make_tile_mesh(mesh, design.cuts, design.parameters.H_body);
  FlatCorners projected(tiles.tile_count(), 6);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      projected.row(i).segment<2>(2 * t) = spread * mesh.V.row(mesh.F(i, t)).head<2>();
    }
  }
  design.T = flat_corners(tiles, fit_poses(tiles, projected));
  design.q.setConstant(tiles.tile_count(), 6, inset);
  return design;
}

}  // namespace curveups::testing
