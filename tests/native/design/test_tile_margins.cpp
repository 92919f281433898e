// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/design/tile_margins.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

Parameters plain() {
  Parameters p;
  p.bumps = "none";
  p.xy_compensation = 0;
  return p;
}

TEST(TileMargins, AFlatSheetLacksNothing) {
  const Parameters p = plain();
  const TileMargins margins = tile_margins(test::flat_patch(), no_cuts, p);
  ASSERT_TRUE(margins.shaped);
  EXPECT_TRUE(margins.back_scale.isApproxToConstant(1, 1e-12));
  EXPECT_TRUE(margins.interface_share.isApproxToConstant(1, 1e-9));
  EXPECT_TRUE(margins.membrane_clearance.isApproxToConstant(p.H_pin, 1e-12));
  EXPECT_TRUE(margins.trimmed.empty() && margins.overlapping.empty());
}

TEST(TileMargins, AFoldThatGrowsByItsRoomTakesTheBackFace) {
  const Parameters p = plain();
  for (double dihedral : {-0.6, 0.0, 0.5}) {
    const TileMargins margins = tile_margins(test::hinge(dihedral, 10), no_cuts, p);
    const double margin = margins.dihedral_margin[0] * M_PI / 180;
    ASSERT_GT(margin, 0.1);
    const TileMargins just = tile_margins(test::hinge(dihedral + 0.999 * margin, 10), no_cuts, p);
    EXPECT_GT(just.back_scale.minCoeff(), 0);
    EXPECT_LT(just.back_scale.minCoeff(), 0.02);
    const TileMargins over = tile_margins(test::hinge(dihedral + 1.001 * margin, 10), no_cuts, p);
    EXPECT_FALSE(over.shaped);
    EXPECT_LT(over.dihedral_margin[0], 0);
    EXPECT_EQ(over.pin_area.rows(), 0);
  }
}

// A pyramid of `count` equal sides whose faces fall by `slope` (rad).
TriangleMesh pyramid(int count, double slope, double size) {
  TriangleMesh mesh;
  mesh.V.resize(count + 1, 3);
  mesh.F.resize(count, 3);
  const double apothem = size * std::cos(M_PI / count);
  mesh.V.row(0) << 0, 0, apothem * std::tan(slope);
  for (int k = 0; k < count; ++k) {
    const double a = 2 * M_PI * k / count;
    mesh.V.row(k + 1) << size * std::cos(a), size * std::sin(a), 0;
    mesh.F.row(k) << 0, k + 1, (k + 1) % count + 1;
  }
  return mesh;
}

TEST(TileMargins, MembranesHaveTheRoomOfThePinsAroundATip) {
  const Parameters p = plain();
  const int count = 6;
  for (double slope : {0.2, 0.5}) {
    const TriangleMesh mesh = pyramid(count, slope, 20);
    const TileMargins margins = tile_margins(mesh, no_cuts, p);
    // The pin's corner is on the face's line of fall, where p_min from both edges of the tip.
    const Vec3 a = mesh.V.row(1) - mesh.V.row(0), b = mesh.V.row(2) - mesh.V.row(0);
    const double half = 0.5 * std::acos(a.dot(b) / (a.norm() * b.norm()));
    const double away = p.p_min / std::sin(half);
    const double expected = p.H_pin * std::cos(slope) - away * std::sin(slope);
    EXPECT_NEAR(margins.membrane_clearance.col(0).minCoeff(), expected, 1e-9);
  }
  EXPECT_LT(tile_margins(pyramid(count, 0.9, 20), no_cuts, p).membrane_clearance.minCoeff(), 0);
  // Turned over, the tip is on the back.
  TriangleMesh over = pyramid(count, 0.9, 20);
  over.F.col(1).swap(over.F.col(2));
  Parameters thin = p;
  thin.H_body = 0.2;
  const TileMargins margins = tile_margins(over, no_cuts, thin);
  EXPECT_LT(margins.membrane_clearance.col(1).minCoeff(), 0);
  EXPECT_GT(margins.membrane_clearance.col(0).minCoeff(), 0);
}

TEST(TileMargins, SheetsNearerThanTheirTilesAreNamedInPairs) {
  const TriangleMesh one = test::flat_square(3, 24);
  const int vertices = static_cast<int>(one.V.rows()), faces = static_cast<int>(one.F.rows());
  auto two = [&](double distance) {
    TriangleMesh mesh;
    mesh.V.resize(2 * vertices, 3);
    mesh.F.resize(2 * faces, 3);
    mesh.V << one.V, one.V;
    mesh.V.bottomRows(vertices).col(2).array() -= distance;
    mesh.F << one.F, (one.F.array() + vertices).matrix();
    return tile_margins(mesh, no_cuts, plain());
  };
  EXPECT_TRUE(two(3.5).trimmed.empty() && two(3.5).overlapping.empty());
  const TileMargins near = two(1.0);
  ASSERT_FALSE(near.overlapping.empty());
  for (const std::array<int, 2>& pair : near.overlapping) {
    EXPECT_LT(pair[0], faces);
    EXPECT_GE(pair[1], faces);
  }
}

TEST(TileMargins, PinsLoseAreaWithThicknessOnARidge) {
  Parameters p = plain();
  double before = 1e9;
  for (double H_body : {1.0, 2.0, 3.0, 4.0}) {
    p.H_body = H_body;
    const TileMargins margins = tile_margins(test::dome(), no_cuts, p);
    EXPECT_LT(margins.pin_area.col(1).minCoeff(), before);
    EXPECT_GT(margins.pin_area.col(0).minCoeff(), margins.pin_area.col(1).minCoeff());
    before = margins.pin_area.col(1).minCoeff();
  }
}

}  // namespace
}  // namespace curveups
