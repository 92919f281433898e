// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/design/constraints.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

// Tiles of a flat patch, spread by a factor.
FlatPoses spread(const TileMesh& tiles, double factor) {
  FlatCorners corners(tiles.tile_count(), 6);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    Vec2 middle = Vec2::Zero();
    for (int t = 0; t < 3; ++t) middle += tiles.mesh.V.row(tiles.mesh.F(i, t)).head<2>() / 3;
    for (int t = 0; t < 3; ++t) {
      const Vec2 p = tiles.mesh.V.row(tiles.mesh.F(i, t)).head<2>();
      corners.row(i).segment<2>(2 * t) = (p + (factor - 1) * middle).transpose();
    }
  }
  return fit_poses(tiles, corners);
}

TEST(Constraints, FindsExactlyThePairsThatAreTooNear) {
  const TriangleMesh mesh = test::flat_patch(5);
  const TileMesh tiles = make_tile_mesh(mesh, no_cuts, 3);
  // Spread by f the gap of neighbours is (f - 1) times twice the inradius.
  const double inradius = 7 * std::sqrt(0.75) / 3;
  const double factor = 1 + 0.6 / (2 * inradius);
  EXPECT_TRUE(find_close_pairs(tiles, spread(tiles, factor), 0.6 - 1e-9).empty());
  FlatPoses poses = spread(tiles, factor);
  poses(10, 0) += 0.2;
  for (const Separation& pair : find_close_pairs(tiles, poses, 0.6 - 1e-9)) {
    EXPECT_TRUE(pair.tile == 10 || pair.other == 10);
    EXPECT_GT(pair.distance, 0.3);
  }
  EXPECT_FALSE(find_close_pairs(tiles, poses, 0.6 - 1e-9).empty());
}

TEST(Constraints, DoNotDependOnHowTheLayoutIsTurned) {
  std::srand(5);
  const TileMesh tiles = make_tile_mesh(test::ripples(5), no_cuts, 3);
  FlatPoses poses = spread(tiles, 1.05);
  const std::size_t count = find_close_pairs(tiles, poses, 0.6).size();
  ASSERT_GT(count, 3u);
  for (double angle : {0.3, 1.1, 2.9}) {
    const PlaneRotation turn(angle);
    FlatPoses turned = poses;
    for (int i = 0; i < poses.rows(); ++i) {
      const Vec2 p = turn * Vec2(poses(i, 0), poses(i, 1));
      turned.row(i) << p.x() + 100, p.y() - 7, poses(i, 2) + angle;
    }
    EXPECT_EQ(find_close_pairs(tiles, turned, 0.6).size(), count);
  }
}

TEST(Constraints, ReportMeasuresEachViolation) {
  Parameters p;
  p.bumps = "none";
  p.xy_compensation = 0;
  const TriangleMesh mesh = test::flat_patch(4);
  const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
  const double inradius = 7 * std::sqrt(0.75) / 3;
  FlatCorners corners =
      flat_corners(geometry.tiles, spread(geometry.tiles, 1 + 0.6 / (2 * inradius)));
  Array6 q = Array6::Constant(geometry.tiles.tile_count(), 6, 0.7);
  ConstraintReport report = check_constraints(geometry, corners, q, p);
  EXPECT_LT(report.max_gap_violation_mm, 1e-9);
  EXPECT_LT(report.max_rigidity_mm, 1e-9);
  EXPECT_EQ(report.max_pin_bound_violation_mm, 0);
  EXPECT_TRUE(report.small_pins.empty() && report.close_pairs.empty());
  q(3, 1) = 0.55;
  q(4, 5) = 2.5;
  corners(7, 0) += 0.01;
  report = check_constraints(geometry, corners, q, p);
  EXPECT_NEAR(report.max_pin_bound_violation_mm, 0.05, 1e-12);
  ASSERT_EQ(report.small_pins.size(), 1u);
  EXPECT_EQ(report.small_pins[0].tile, 4);
  EXPECT_EQ(report.small_pins[0].side, Side::back);
  EXPECT_GT(report.max_rigidity_mm, 1e-3);
  corners = flat_corners(geometry.tiles, spread(geometry.tiles, 1 + 0.5 / (2 * inradius)));
  report = check_constraints(geometry, corners, q, p);
  EXPECT_NEAR(report.max_gap_violation_mm, 0.1, 1e-9);
  EXPECT_FALSE(report.close_pairs.empty());
}

TEST(Constraints, FlatAreaOfAFlatLayoutIsItsRegion) {
  Parameters p;
  const TriangleMesh mesh = test::flat_patch(5);
  const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
  const FlatCorners together = flat_corners(geometry.tiles, spread(geometry.tiles, 1));
  EXPECT_NEAR(flat_area(geometry, together), surface_area(mesh), 1e-6);
  // Spread by f, tiles with gaps and vertex polygons fill the region that their corners outline.
  const double f = 1.2;
  const FlatCorners apart = flat_corners(geometry.tiles, spread(geometry.tiles, f));
  EXPECT_GT(flat_area(geometry, apart), surface_area(mesh) * 1.2);
  EXPECT_LT(flat_area(geometry, apart), surface_area(mesh) * f * f);
}

}  // namespace
}  // namespace curveups
