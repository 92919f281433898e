// SPDX-License-Identifier: LGPL-2.1-or-later
// A flat sheet whose outline is held: membranes with closed-form solutions.
#pragma once

#include "curveups/geometry/planar_mesh.hpp"
#include "curveups/physics/equilibrium.hpp"

namespace curveups::test {

struct Sheet {
  MembraneMesh mesh;
  Points2 flat;
};

// A rectangle of side lengths a and b with edges of about `size`; outline vertices are glued to
// "tile" 0. Weights are not meaningful (one fictitious corner per vertex).
inline Sheet make_sheet(double a, double b, double size) {
  const std::vector<Vec2> corners = {{0, 0}, {a, 0}, {a, b}, {0, b}};
  std::vector<Vec2> boundary;
  for (int i = 0; i < 4; ++i) {
    const Vec2 &p = corners[i], &q = corners[(i + 1) % 4];
    const int parts = static_cast<int>(std::ceil((q - p).norm() / size));
    for (int k = 0; k < parts; ++k) boundary.push_back(p + (q - p) * k / parts);
  }
  const PlanarMesh planar = mesh_polygon(boundary, [&](const Vec2&) { return 1.2 * size; });
  Sheet sheet;
  sheet.flat.resize(planar.points.size(), 2);
  for (std::size_t v = 0; v < planar.points.size(); ++v) {
    sheet.flat.row(v) = planar.points[v].transpose();
    sheet.mesh.weights.corner.push_back(static_cast<int>(v));
    sheet.mesh.weights.weight.push_back(1);
    sheet.mesh.weights.start.push_back(static_cast<int>(v) + 1);
    sheet.mesh.pin.push_back(v < boundary.size() ? 0 : -1);
  }
  sheet.mesh.triangles = planar.triangles;
  sheet.mesh.patch.assign(planar.triangles.size(), 0);
  return sheet;
}

}  // namespace curveups::test
