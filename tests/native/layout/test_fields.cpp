// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/layout/fields.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "support/designs.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

TEST(TargetFields, FoldsAreTheDihedralAnglesWithTheirSign) {
  for (double dihedral : {0.4, -0.7}) {
    const TargetFields fields = target_fields(test::hinge(dihedral, 20), no_cuts, {});
    ASSERT_EQ(fields.dihedral.size(), 1);
    EXPECT_NEAR(fields.dihedral[0], dihedral * 180 / M_PI, 1e-9);
  }
}

TEST(TargetFields, AFlatTargetIsStretchedByWhatItsGapsTake) {
  Parameters p;
  p.bumps = "none";
  p.xy_compensation = 0;
  const TargetFields fields = target_fields(test::flat_patch(), no_cuts, p);
  // Equal tiles of inradius r with gaps of d: every place is scaled by 1 + d / (2 r).
  const TileMesh tiles = make_tile_mesh(test::flat_patch(), no_cuts, p.H_body);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    EXPECT_NEAR(fields.least_stretch[i], 1 + 0.5 * p.d_gap_min / tile_inradius(tiles, i), 1e-12);
    EXPECT_NEAR(fields.stretch[i], fields.least_stretch[i], 1e-6);
    EXPECT_GT(fields.most_stretch[i], fields.stretch[i]);
    // Pins p_min from all edges of a triangle: its area by the inradius.
    const double r = tile_inradius(tiles, i), left = 1 - p.p_min / r;
    for (int side = 0; side < 2; ++side) {
      EXPECT_NEAR(fields.pin_area_margin(i, side), tiles.area(i) * left * left - p.A_pin_min, 1e-9);
    }
  }
}

TEST(TargetFields, MembranesAreSlackBeyondMostStretch) {
  // Flat: pins 2 q + gap apart at rest, 2 q tau when it is pulled taut, no fold, the largest q that
  // A_pin_min leaves.
  Parameters p;
  p.bumps = "none";
  p.A_pin_min = 10;
  const TileMesh tiles = make_tile_mesh(test::flat_patch(), no_cuts, p.H_body);
  const TargetFields fields = target_fields(tiles.mesh, no_cuts, p);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double r = tile_inradius(tiles, i);
    const double q = std::min(p.p_max, r * (1 - std::sqrt(p.A_pin_min / tiles.area(i))));
    EXPECT_NEAR(fields.most_stretch[i], 1 + 2 * q * (p.tau - 1) / (2 * r), 1e-9);
  }
}

TEST(TargetFields, WhatCannotBeMadeIsShownRatherThanRefused) {
  Parameters thick;
  thick.H_body = 60;
  const TargetFields fields = target_fields(test::cone(), no_cuts, thick);
  EXPECT_LT(fields.pin_area_margin.minCoeff(), 0);
  EXPECT_TRUE(fields.pin_area_margin.allFinite());
  // A closed surface has folds and no flat map.
  const TargetFields closed = target_fields(test::sphere(3, 30), no_cuts, {});
  EXPECT_TRUE(closed.dihedral.allFinite());
  EXPECT_GT(closed.dihedral.mean(), 0);
  EXPECT_TRUE(closed.stretch.array().isNaN().all());
  TriangleMesh broken = test::dome(3);
  broken.F(0, 0) = 100000;
  EXPECT_THROW(target_fields(broken, no_cuts, {}), TopologyError);
  broken = test::dome(3);
  broken.V(2, 1) = std::nan("");
  EXPECT_THROW(target_fields(broken, no_cuts, {}), InvalidInput);
}

TEST(DesignFields, GapsAndAreasAreThoseOfTheLayout) {
  // A flat strip spread by s: neighbours' edges are apart by their share of it.
  Parameters p;
  p.bumps = "none";
  const Design design = test::spread_design(test::flat_patch(4, 8), 1.5, 0.7);
  const DesignFields fields = design_fields(design);
  const TileMesh tiles = make_tile_mesh(design.mesh, no_cuts, design.parameters.H_body);
  ASSERT_EQ(fields.gap.size(), static_cast<Eigen::Index>(tiles.contacts.size()));
  for (Eigen::Index k = 0; k < fields.gap.size(); ++k) {
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
    EXPECT_NEAR(fields.gap[k], 0.5 * across, 1e-9);  // (1.5 - 1) times the way across the edge
  }
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const double left = 1 - 0.7 / tile_inradius(tiles, i);
    EXPECT_NEAR(fields.pin_area(i, 0), tiles.area(i) * left * left, 1e-9);
  }
}

}  // namespace
}  // namespace curveups
