// SPDX-License-Identifier: LGPL-2.1-or-later
// Small whole designs for the tests of this room: a curved patch over a triangular grid, its tiles
// laid out rigidly where the patch's plan has them, spread apart.
#pragma once

#include <cmath>
#include <map>

#include "curveups/design/design.hpp"

namespace curveups::test {

struct SampleOptions {
  int rows = 4, columns = 5;
  double kx = 0.012, ky = 0.012;  // z = -(kx x^2 + ky y^2) / 2: a dome; opposite signs: a saddle
  double spread = 1.45;
  Edges cuts = Edges(0, 2);
  double piece_offset = 0;  // moves tiles with an x of the plan above 0 further right
};

inline Design sample_design(const Parameters& parameters = {}, const SampleOptions& o = {}) {
  Design design;
  design.name = "sample";
  design.parameters = parameters;
  const double L = parameters.L;
  const int nx = o.columns + 1, ny = o.rows + 1;
  design.mesh.V.resize(nx * ny, 3);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const double x = L * (i - 0.5 * o.columns + 0.5 * (j % 2) - 0.25);
      const double y = L * std::sqrt(0.75) * (j - 0.5 * o.rows);
      design.mesh.V.row(j * nx + i) << x, y, -0.5 * (o.kx * x * x + o.ky * y * y);
    }
  }
  design.mesh.F.resize(2 * o.rows * o.columns, 3);
  int f = 0;
  for (int j = 0; j < o.rows; ++j) {
    for (int i = 0; i < o.columns; ++i) {
      const int a = j * nx + i, b = a + 1, c = a + nx, d = c + 1;
      if (j % 2 == 0) {
        design.mesh.F.row(f++) << a, b, c;
        design.mesh.F.row(f++) << b, d, c;
      } else {
        design.mesh.F.row(f++) << a, b, d;
        design.mesh.F.row(f++) << a, d, c;
      }
    }
  }
  design.cuts = o.cuts;
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, parameters);
  FlatCorners plan(f, 6);
  for (int i = 0; i < f; ++i) {
    Vec2 centre = Vec2::Zero();
    for (int k = 0; k < 3; ++k) {
      centre += design.mesh.V.row(design.mesh.F(i, k)).head<2>().transpose() / 3;
    }
    for (int k = 0; k < 3; ++k) {
      Vec2 p = design.mesh.V.row(design.mesh.F(i, k)).head<2>().transpose();
      p += (o.spread - 1) * centre;
      if (centre.x() > 0) p.x() += o.piece_offset;
      plan.block<1, 2>(i, 2 * k) = p.transpose();
    }
  }
  design.T = flat_corners(geometry.tiles, fit_poses(geometry.tiles, plan));
  design.q = geometry.pin_bounds.lower.array() + 0.02;
  return design;
}

}  // namespace curveups::test
