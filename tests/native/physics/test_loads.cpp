// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/physics/loads.hpp"
#include "curveups/physics/verification.hpp"
#include "support/designs.hpp"
#include "support/findings.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using test::find_kind;
using test::hexagon;
using test::spread_design;

Design dome() { return spread_design(hexagon(3, test::cap_height), 1.35, 1.2); }

TEST(Loads, WeightIsThatOfBodiesAndPins) {
  Design design = dome();
  Parameters& p = design.parameters;
  p.gravity = "held";
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, p);
  auto weight = [&] { return -weights(geometry, design.q, p).col(2).sum(); };
  double bodies = 0, pins = 0;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    bodies += volume(tile_body(geometry.tiles, geometry.truncation, i));
    for (Side side : {Side::front, Side::back}) {
      pins += p.H_pin * pin_area(geometry.tiles, i, side, design.q.row(i).data());
    }
  }
  const double newtons = 9.80665e-6 * p.density;
  const double recessed = weight();
  p.bumps = "none";
  p.xy_compensation = 0;
  EXPECT_NEAR(weight() / (newtons * (bodies + pins)), 1, 1e-9);
  EXPECT_LT(recessed, weight());
  EXPECT_GT(recessed, 0.8 * weight());
}

TEST(Loads, APieceThatNothingCarriesIsSaid) {
  // Two domes, one above the other's height, in one mesh.
  const TriangleMesh one = hexagon(1, test::cap_height);
  const int n = static_cast<int>(one.V.rows()), m = static_cast<int>(one.F.rows());
  TriangleMesh both;
  both.V.resize(2 * n, 3);
  both.F.resize(2 * m, 3);
  both.V << one.V, one.V;
  both.V.bottomRows(n).rowwise() += Eigen::RowVector3d(60, 0, 20);
  both.F << one.F, one.F.array() + n;
  Design design = spread_design(both, 1.35, 1.2);
  design.parameters.gravity = "resting";
  const VerificationReport resting = verify_design(design, {});
  EXPECT_FALSE(resting.valid);
  const Finding* alone = find_kind(resting.reasons, "in_the_air");
  ASSERT_NE(alone, nullptr);
  EXPECT_EQ(alone->tiles, std::vector<int>{m});
  design.parameters.gravity = "held";
  design.parameters.held_tiles = "T00001";
  EXPECT_NE(find_kind(verify_design(design, {}).reasons, "in_the_air.held"), nullptr);
  design.parameters.held_tiles = "";
  EXPECT_EQ(find_kind(verify_design(design, {}).reasons, "in_the_air.held"), nullptr);
}

TEST(Loads, GravityIsCarriedByHeldTilesOrByThePlane) {
  Design design = dome();
  design.parameters.gravity = "held";
  design.parameters.density = 1.18;
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  // The default: the lowest tile and those around it.
  const std::vector<int> grip = held_tiles(geometry, design.parameters);
  int lowest = 0;
  const Points3 centres = tile_centres(geometry.tiles);
  centres.col(2).minCoeff(&lowest);
  EXPECT_TRUE(std::binary_search(grip.begin(), grip.end(), lowest));
  EXPECT_GE(grip.size(), 3u);
  EXPECT_LE(grip.size(), 13u);
  design.parameters.held_tiles = tile_name(lowest);
  const VerificationReport light = verify_design(design, {});
  EXPECT_LT(light.contact_forces.imbalance, 1e-9);
  design.parameters.held_tiles = "T00001, T00004,T00008";
  const VerificationReport held = verify_design(design, {});
  EXPECT_LT(held.contact_forces.imbalance, 1e-9);
  // Ends of the dome carry it in different ways.
  EXPECT_NE(held.contact_forces.normal_min, light.contact_forces.normal_min);
  // Two held neighbours need no force at their contact.
  const std::array<int, 2> pair = {light.contact_tiles(0, 0), light.contact_tiles(0, 1)};
  design.parameters.held_tiles = tile_name(pair[0]) + "," + tile_name(pair[1]);
  const VerificationReport both = verify_design(design, {});
  EXPECT_TRUE(std::isnan(both.contact_normal_min(0)));
  EXPECT_GT(both.contact_forces.points, 0);
  EXPECT_LT(both.contact_forces.points, light.contact_forces.points);
  EXPECT_TRUE(std::find(both.contact_forces.invalid_contacts.begin(),
                        both.contact_forces.invalid_contacts.end(),
                        pair) == both.contact_forces.invalid_contacts.end());
  design.parameters.held_tiles = "T00055";
  EXPECT_THROW(verify_design(design, {}), InvalidInput);
  design.parameters.held_tiles = "";
  // A density far beyond any material pulls the piece apart.
  design.parameters.density = 30;
  design.parameters.shear_modulus_front = design.parameters.shear_modulus_back = 1e-3;
  const VerificationReport heavy = verify_design(design, {});
  EXPECT_FALSE(heavy.valid);
}

// Tile, its back down on a table, with the weight acting at `place` of its back's corners.
Carried one_tile_on_a_table(const Vec3& place) {
  TriangleMesh one;
  one.V.resize(3, 3);
  one.V << 0, 0, 0, 12, 0, 0, 3, 9, 0;
  one.F.resize(1, 3);
  one.F << 0, 1, 2;
  Parameters p;
  p.gravity = "resting";
  const DesignGeometry geometry = make_geometry(one, Edges(0, 2), p);
  Wrenches weight = Wrenches::Zero(1, 6);
  const Vec3 at = one.V.transpose() * place - tile_centres(geometry.tiles).row(0).transpose();
  weight.row(0) << 5 * gravity_down.transpose(), at.cross(5 * gravity_down).transpose();
  return carry(geometry, weight, p);
}

TEST(Loads, ATableBalancesABlockOnThreePointsAndOnlyPushes) {
  const Carried carried = one_tile_on_a_table({0.2, 0.5, 0.3});
  EXPECT_TRUE(carried.tipping.empty());
  EXPECT_LT((carried.table.row(0).head<3>() + 5 * gravity_down.transpose()).norm(), 1e-9);
  // Any beside one edge tips it.
  EXPECT_EQ(one_tile_on_a_table({-0.01, 0.5, 0.51}).tipping, std::vector<int>{0});
  EXPECT_EQ(one_tile_on_a_table({0.6, 0.6, -0.2}).tipping, std::vector<int>{0});
  EXPECT_TRUE(one_tile_on_a_table({0.01, 0.5, 0.49}).tipping.empty());
}

TEST(Loads, ATableCarriesTheWeightAndNoneOfTheTension) {
  Design design = dome();
  design.parameters.density = 1.18;
  const VerificationReport alone = verify_design(design, {});
  ASSERT_TRUE(alone.valid);
  design.parameters.gravity = "resting";
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const Wrenches weight = weights(geometry, design.q, design.parameters);
  const Carried carried = carry(geometry, weight, design.parameters);
  EXPECT_NEAR(carried.table.col(2).sum() / -weight.col(2).sum(), 1, 1e-9);
  EXPECT_GE(carried.table.col(2).minCoeff(), 0);
  EXPECT_EQ(carried.table.leftCols<2>().cwiseAbs().maxCoeff(), 0);
  const Points3 centres = tile_centres(geometry.tiles);
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < weight.rows(); ++i) {
    const Eigen::Matrix<double, 1, 6> both = weight.row(i) + carried.table.row(i);
    torque +=
        both.tail<3>().transpose() + Vec3(centres.row(i)).cross(Vec3(both.head<3>().transpose()));
  }
  EXPECT_LT(torque.norm(), 1e-9);
  // A dome that holds by itself holds on a table: at once where it is light, in the limit exactly.
  const VerificationReport resting = verify_design(design, {});
  EXPECT_TRUE(resting.valid);
  EXPECT_NEAR(resting.contact_forces.normal_min, alone.contact_forces.normal_min,
              0.05 * alone.contact_forces.normal_mean);
  EXPECT_LT(resting.contact_forces.imbalance, 1e-6);
  design.parameters.density = 1e-6;
  const VerificationReport weightless = verify_design(design, {});
  EXPECT_NEAR(weightless.contact_forces.normal_min, alone.contact_forces.normal_min, 2e-3);
  EXPECT_NEAR(weightless.unilateral.largest_floor, alone.unilateral.largest_floor, 2e-3);
  // On its side it stands on its rim, beside which its weight acts.
  design.parameters = dome().parameters;
  design.parameters.gravity = "resting";
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), -Vec3::UnitZ()).toRotationMatrix();
  design.mesh.V *= turn.transpose();
  EXPECT_NE(find_kind(verify_design(design, {}).reasons, "tips_over"), nullptr);
}

}  // namespace
}  // namespace curveups
