// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/layout/layout.hpp"
#include "curveups/refinement/vertex_rows.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

// Gaps and pin areas by all vertices, flat centroids and angles held, against whole designs with
// their vertices moved.
TEST(VertexRows, MatchFiniteDifferences) {
  const TriangleMesh mesh = test::ripples(5);
  Edges cuts(2, 2);
  cuts << 12, 13, 13, 14;
  const Parameters parameters;
  const DesignGeometry geometry = make_geometry(mesh, cuts, parameters);
  const LayoutModel model = make_layout_model(geometry, parameters);
  const LayoutResult layout = solve_layout(geometry, parameters, {});
  const LayoutState state = state_of(model, layout.poses, layout.q);
  const LayoutTerms constraints = make_constraints(model);
  std::vector<ConstraintRow> rows;
  for (int f = 0; f < static_cast<int>(constraints.size()); ++f) {
    if (constraints[f]->name() == "pin keep-out") continue;  // renewed with the geometry
    for (int b = 0; b < constraints[f]->element_count(); ++b) rows.push_back({f, b});
  }
  MovingVertices moving;
  const VertexPatches patches(geometry);
  for (int v = 0; v < mesh.V.rows(); ++v) {
    moving.vertex.push_back(v);
    moving.patches.push_back(patches.around(v));
  }
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points3 direction(mesh.V.rows(), 3);
  for (int v = 0; v < direction.rows(); ++v) {
    direction.row(v) << uniform(generator), uniform(generator), uniform(generator);
  }
  Eigen::VectorXd exact = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
  for (const VertexEntry& entry : rows_by_vertex(model, state, rows, moving)) {
    exact(entry.row) += entry.derivative.dot(Vec3(direction.row(entry.vertex)));
  }
  const double step = 1e-4;
  std::array<Eigen::VectorXd, 2> values;
  for (int k = 0; k < 2; ++k) {
    const double h = k == 0 ? -step : step;
    DesignGeometry moved = make_geometry({mesh.V + h * direction, mesh.F}, cuts, parameters);
    moved.pin_bounds.least_area = geometry.pin_bounds.least_area;  // renewed as well
    const LayoutModel there = make_layout_model(moved, parameters);
    const LayoutTerms functions = make_constraints(there);
    values[k].resize(exact.size());
    LayoutTerm::Value value;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      functions[rows[r].function]->at(rows[r].block, state, false, value);
      values[k](static_cast<Eigen::Index>(r)) = value.value(0);
    }
  }
  const Eigen::VectorXd difference = (values[1] - values[0]) / (2 * step);
  EXPECT_GT(difference.norm(), 1);
  EXPECT_LT((exact - difference).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(VertexRows, KnowHowCentroidsMove) {
  const TriangleMesh mesh = test::dome(3);
  const DesignGeometry geometry = make_geometry(mesh, Edges(0, 2), {});
  const double step = 1e-5;
  auto centroid = [](const TileMesh& tiles, int i) {
    return Vec2((tiles.front[i][0] + tiles.front[i][1] + tiles.front[i][2]) / 3);
  };
  for (int tile : {0, 5, 11}) {
    for (int t = 0; t < 3; ++t) {
      const auto exact = centroid_by_corner(geometry.tiles, tile, t);
      for (int c = 0; c < 3; ++c) {
        TriangleMesh a = mesh, b = mesh;
        a.V(mesh.F(tile, t), c) -= step;
        b.V(mesh.F(tile, t), c) += step;
        const Vec2 difference = (centroid(make_tile_mesh(b, Edges(0, 2), 3), tile) -
                                 centroid(make_tile_mesh(a, Edges(0, 2), 3), tile)) /
                                (2 * step);
        EXPECT_LT((exact.col(c) - difference).norm(), 1e-8);
      }
    }
  }
}

}  // namespace
}  // namespace curveups
