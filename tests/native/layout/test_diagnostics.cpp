// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/layout/diagnostics.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "support/designs.hpp"
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

TEST(TargetFigures, AFlatSheetLacksNothing) {
  const Parameters p = plain();
  const TargetFigures margins = target_figures(test::flat_patch(), no_cuts, p);
  ASSERT_TRUE(margins.shaped);
  EXPECT_TRUE(margins.back_scale.isApproxToConstant(1, 1e-12));
  EXPECT_TRUE(margins.interface_share.isApproxToConstant(1, 1e-9));
  EXPECT_TRUE(margins.membrane_clearance.isApproxToConstant(p.H_pin, 1e-12));
  EXPECT_TRUE(margins.trimmed.empty() && margins.overlapping.empty());
}

TEST(TargetFigures, AFoldThatGrowsByItsRoomTakesTheBackFace) {
  const Parameters p = plain();
  for (double dihedral : {-0.6, 0.0, 0.5}) {
    const TargetFigures margins = target_figures(test::hinge(dihedral, 10), no_cuts, p);
    const double margin = margins.dihedral_margin[0] * M_PI / 180;
    ASSERT_GT(margin, 0.1);
    const TargetFigures just =
        target_figures(test::hinge(dihedral + 0.999 * margin, 10), no_cuts, p);
    EXPECT_GT(just.back_scale.minCoeff(), 0);
    EXPECT_LT(just.back_scale.minCoeff(), 0.02);
    const TargetFigures over =
        target_figures(test::hinge(dihedral + 1.001 * margin, 10), no_cuts, p);
    EXPECT_FALSE(over.shaped);
    EXPECT_LT(over.dihedral_margin[0], 0);
    EXPECT_EQ(over.membrane_clearance.rows(), 0);
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

TEST(TargetFigures, MembranesHaveTheRoomOfThePinsAroundATip) {
  const Parameters p = plain();
  const int count = 6;
  for (double slope : {0.2, 0.5}) {
    const TriangleMesh mesh = pyramid(count, slope, 20);
    const TargetFigures margins = target_figures(mesh, no_cuts, p);
    // The pin's corner is on the face's line of fall, where p_min from both edges of the tip.
    const Vec3 a = mesh.V.row(1) - mesh.V.row(0), b = mesh.V.row(2) - mesh.V.row(0);
    const double half = 0.5 * std::acos(a.dot(b) / (a.norm() * b.norm()));
    const double away = p.p_min / std::sin(half);
    const double expected = p.H_pin * std::cos(slope) - away * std::sin(slope);
    EXPECT_NEAR(margins.membrane_clearance.col(0).minCoeff(), expected, 1e-9);
  }
  EXPECT_LT(target_figures(pyramid(count, 0.9, 20), no_cuts, p).membrane_clearance.minCoeff(), 0);
  // Turned over, the tip is on the back.
  TriangleMesh over = pyramid(count, 0.9, 20);
  over.F.col(1).swap(over.F.col(2));
  Parameters thin = p;
  thin.H_body = 0.2;
  const TargetFigures margins = target_figures(over, no_cuts, thin);
  EXPECT_LT(margins.membrane_clearance.col(1).minCoeff(), 0);
  EXPECT_GT(margins.membrane_clearance.col(0).minCoeff(), 0);
}

TEST(TargetFigures, SheetsNearerThanTheirTilesAreNamedInPairs) {
  const TriangleMesh one = test::flat_square(3, 24);
  const int vertices = static_cast<int>(one.V.rows()), faces = static_cast<int>(one.F.rows());
  auto two = [&](double distance) {
    TriangleMesh mesh;
    mesh.V.resize(2 * vertices, 3);
    mesh.F.resize(2 * faces, 3);
    mesh.V << one.V, one.V;
    mesh.V.bottomRows(vertices).col(2).array() -= distance;
    mesh.F << one.F, (one.F.array() + vertices).matrix();
    return target_figures(mesh, no_cuts, plain());
  };
  EXPECT_TRUE(two(3.5).trimmed.empty() && two(3.5).overlapping.empty());
  const TargetFigures near = two(1.0);
  ASSERT_FALSE(near.overlapping.empty());
  for (const std::array<int, 2>& pair : near.overlapping) {
    EXPECT_LT(pair[0], faces);
    EXPECT_GE(pair[1], faces);
  }
}

TEST(TargetFigures, PinsLoseAreaWithThicknessOnARidge) {
  Parameters p = plain();
  double before = 1e9;
  for (double H_body : {1.0, 2.0, 3.0, 4.0}) {
    p.H_body = H_body;
    const TargetFigures margins = target_figures(test::dome(), no_cuts, p);
    EXPECT_LT(margins.pin_area.col(1).minCoeff(), before);
    EXPECT_GT(margins.pin_area.col(0).minCoeff(), margins.pin_area.col(1).minCoeff());
    before = margins.pin_area.col(1).minCoeff();
  }
}

TEST(TargetFigures, FoldsAreTheDihedralAnglesWithTheirSign) {
  for (double dihedral : {0.4, -0.7}) {
    const TargetFigures figures = target_figures(test::hinge(dihedral, 20), no_cuts, {});
    ASSERT_EQ(figures.dihedral.size(), 1);
    EXPECT_NEAR(figures.dihedral[0], dihedral * 180 / M_PI, 1e-9);
  }
}

TEST(TargetFigures, AFlatTargetIsStretchedByWhatItsGapsTake) {
  Parameters p;
  p.bumps = "none";
  p.xy_compensation = 0;
  const TargetFigures figures = target_figures(test::flat_patch(), no_cuts, p);
  // Equal tiles of inradius r with gaps of d: every place is scaled by 1 + d / (2 r).
  const TileMesh tiles = make_tile_mesh(test::flat_patch(), no_cuts, p.H_body);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    EXPECT_NEAR(figures.least_stretch[i], 1 + 0.5 * p.d_gap_min / tile_inradius(tiles, i), 1e-12);
    EXPECT_NEAR(figures.stretch[i], figures.least_stretch[i], 1e-6);
    EXPECT_GT(figures.most_stretch[i], figures.stretch[i]);
    // Pins p_min from all edges of a triangle: its area by the inradius.
    const double r = tile_inradius(tiles, i), left = 1 - p.p_min / r;
    for (int side = 0; side < 2; ++side) {
      EXPECT_NEAR(figures.pin_area(i, side), tiles.area(i) * left * left, 1e-9);
    }
  }
}

TEST(TargetFigures, MembranesAreSlackBeyondMostStretch) {
  // Flat: pins 2 q + gap apart at rest, 2 q tau when it is pulled taut, no fold, the largest q that
  // A_pin_min leaves.
  Parameters p;
  p.bumps = "none";
  p.A_pin_min = 10;
  const TileMesh tiles = make_tile_mesh(test::flat_patch(), no_cuts, p.H_body);
  const TargetFigures figures = target_figures(tiles.mesh, no_cuts, p);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double r = tile_inradius(tiles, i);
    const double q = std::min(p.p_max, r * (1 - std::sqrt(p.A_pin_min / tiles.area(i))));
    EXPECT_NEAR(figures.most_stretch[i], 1 + 2 * q * (p.tau - 1) / (2 * r), 1e-9);
  }
}

TEST(TargetFigures, WhatCannotBeMadeIsShownRatherThanRefused) {
  Parameters thick;
  thick.H_body = 60;
  const TargetFigures figures = target_figures(test::cone(), no_cuts, thick);
  EXPECT_FALSE(figures.shaped);
  EXPECT_LT(figures.pin_area.minCoeff(), thick.A_pin_min);
  EXPECT_TRUE(figures.pin_area.allFinite());
  // A closed surface has folds and no flat map.
  const TargetFigures closed = target_figures(test::sphere(3, 30), no_cuts, {});
  EXPECT_TRUE(closed.dihedral.allFinite());
  EXPECT_GT(closed.dihedral.mean(), 0);
  EXPECT_TRUE(closed.stretch.array().isNaN().all());
  TriangleMesh broken = test::dome(3);
  broken.V(2, 1) = std::nan("");
  EXPECT_THROW(target_figures(broken, no_cuts, {}), InvalidInput);
}

TEST(DesignFigures, GapsAndAreasAreThoseOfTheLayout) {
  // A flat strip spread by s: neighbours' edges are apart by their share of it.
  Parameters p;
  p.bumps = "none";
  const Design design = test::spread_design(test::flat_patch(4, 8), 1.5, 0.7);
  const DesignFigures figures = evaluate_design(design);
  const TileMesh tiles = make_tile_mesh(design.mesh, no_cuts, design.parameters.H_body);
  ASSERT_EQ(figures.gap.size(), static_cast<Eigen::Index>(tiles.contacts.size()));
  for (Eigen::Index k = 0; k < figures.gap.size(); ++k) {
    const Contact& contact = tiles.contacts[static_cast<std::size_t>(k)];
    const Vec3 a = tiles.mesh.V.row(tiles.mesh.F(contact.tile[0], contact.side[0]));
    const Vec3 b = tiles.mesh.V.row(tiles.mesh.F(contact.tile[0], next3(contact.side[0])));
    const auto middle = [&](int i) {
      Vec3 sum = Vec3::Zero();
      for (int t = 0; t < 3; ++t) sum += tiles.mesh.V.row(tiles.mesh.F(i, t));
      return Vec3(sum / 3);
    };
    const Vec3 way = middle(contact.tile[1]) - middle(contact.tile[0]);
    const Vec3 along = (b - a).normalized();
    const double across = (way - way.dot(along) * along).norm();
    EXPECT_NEAR(figures.gap[k], 0.5 * across, 1e-9);  // (1.5 - 1) times the way across the edge
  }
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double left = 1 - 0.7 / tile_inradius(tiles, i);
    EXPECT_NEAR(figures.pin_area(i, 0), tiles.area(i) * left * left, 1e-9);
  }
}

TEST(TargetChecks, NameWhatCannotWorkWithItsTiles) {
  Parameters p;
  TriangleMesh sharp;
  sharp.V.resize(4, 3);
  sharp.V << 0, 0, 12, 4, 0, 0, -2, 3.46, 0, -2, -3.46, 0;
  sharp.F.resize(3, 3);
  sharp.F << 0, 1, 2, 0, 2, 3, 0, 3, 1;
  auto findings = check_target(sharp, no_cuts, p);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, "sharp_fold");
  EXPECT_TRUE(findings[0].is_error);
  EXPECT_EQ(findings[0].tiles.size(), 3u);

  findings = check_target(test::cone(), no_cuts, p);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].kind, "small_pin");
  EXPECT_FALSE(findings[0].is_error);
  EXPECT_FALSE(findings[0].tiles.empty());

  EXPECT_TRUE(check_target(test::dome(6, 7, 60), no_cuts, p).empty());
  p.L = 30;
  findings = check_target(test::dome(6, 7, 60), no_cuts, p);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].kind, "edge_length");
}

}  // namespace
}  // namespace curveups
