// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/designs.hpp"

#include <cmath>
#include <vector>

#include "support/meshes.hpp"

namespace curveups::test {

namespace {

// The triangles that `keep` accepts, and the vertices of these.
void keep_only(TriangleMesh& mesh, const std::function<bool(const Vec2&)>& keep) {
  std::vector<int> number(mesh.V.rows(), -1);
  int faces = 0, vertices = 0;
  for (int i = 0; i < mesh.F.rows(); ++i) {
    Vec2 centre = Vec2::Zero();
    for (int k = 0; k < 3; ++k) centre += mesh.V.row(mesh.F(i, k)).head<2>().transpose() / 3;
    if (!keep(centre)) continue;
    for (int k = 0; k < 3; ++k) number[mesh.F(i, k)] = 0;
    mesh.F.row(faces++) = mesh.F.row(i).eval();
  }
  mesh.F.conservativeResize(faces, Eigen::NoChange);
  for (int v = 0; v < mesh.V.rows(); ++v) {
    if (number[v] < 0) continue;
    number[v] = vertices;
    mesh.V.row(vertices++) = mesh.V.row(v).eval();
  }
  mesh.V.conservativeResize(vertices, Eigen::NoChange);
  for (int i = 0; i < faces; ++i) {
    for (int k = 0; k < 3; ++k) mesh.F(i, k) = number[mesh.F(i, k)];
  }
}

}  // namespace

Design sample_design(const Parameters& parameters, const SampleOptions& o) {
  Design design;
  design.name = "sample";
  design.parameters = parameters;
  const double L = parameters.L;
  const double shift = 0.25 * L;  // every second row stands half an edge further right
  design.mesh = lifted_patch(o.rows, o.columns, L, [&](double x, double y) {
    return -0.5 * (o.kx * (x - shift) * (x - shift) + o.ky * y * y);
  });
  design.mesh.V.col(0).array() -= shift;
  if (o.keep) keep_only(design.mesh, o.keep);
  const int f = static_cast<int>(design.mesh.F.rows());
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

Design spread_design(const TriangleMesh& mesh, double spread, double inset) {
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

}  // namespace curveups::test
