// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/physics/design_forces.hpp"
#include "curveups/physics/verification.hpp"
#include "support/designs.hpp"
#include "support/findings.hpp"
#include "support/forces.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

using test::find_kind;
using test::hexagon;
using test::spread_design;

Design dome() { return spread_design(hexagon(3, test::cap_height), 1.35, 1.2); }

TEST(Verify, ADomeBalancesAndPushesEverywhere) {
  const VerificationReport r = verify_design(dome(), {});
  EXPECT_TRUE(r.computed);
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LE(r.physics.fine_iterations[0], 20);
  EXPECT_LE(r.physics.fine_iterations[1], 20);
  EXPECT_LT(r.physics.force_balance, 1e-6);
  EXPECT_LT(r.physics.torque_balance, 1e-6);
  EXPECT_LT(r.contact_forces.imbalance, 1e-9);
  EXPECT_GT(r.contact_forces.normal_mean, 0);
  EXPECT_EQ(r.unilateral.status, SolveStatus::converged);
  EXPECT_TRUE(r.valid);
  EXPECT_TRUE(r.reasons.empty());
}

TEST(Verify, ForcesAreProportionalToStiffness) {
  Design design = dome();
  const VerificationReport a = verify_design(design, {});
  for (double* m : {&design.parameters.shear_modulus_front, &design.parameters.shear_modulus_back})
    *m *= 3;
  design.parameters.glue_strength *= 3;
  const VerificationReport b = verify_design(design, {});
  EXPECT_LT((3 * a.solved->elastic - b.solved->elastic).cwiseAbs().maxCoeff(),
            1e-6 * b.solved->elastic.cwiseAbs().maxCoeff());
  EXPECT_NEAR(b.contact_forces.normal_mean / a.contact_forces.normal_mean, 3, 1e-6);
  EXPECT_EQ(a.valid, b.valid);
  // Different membranes: neither of both.
  design.parameters.shear_modulus_back /= 3;
  const VerificationReport c = verify_design(design, {});
  EXPECT_TRUE(c.physics.converged);
  EXPECT_GT(c.contact_forces.normal_mean, a.contact_forces.normal_mean);
  EXPECT_LT(c.contact_forces.normal_mean, b.contact_forces.normal_mean);
}

TEST(Verify, ALooseLayoutWithWrinklesConverges) {
  const VerificationReport r =
      verify_design(spread_design(hexagon(3, test::cap_height), 1.9, 1.2), {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LE(r.physics.fine_iterations[0], 20);
  EXPECT_LE(r.physics.fine_iterations[1], 20);
  EXPECT_LT(r.physics.force_balance, 1e-6);
}

TEST(Verify, WithoutStretchTheMembranesGoSlackAndNothingIsValid) {
  Design design = dome();
  design.parameters.tau = 1.05;
  const VerificationReport r = verify_design(design, {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_GT(r.physics.wrinkled_fraction, 0.15);
  EXPECT_FALSE(r.valid);
}

TEST(Verify, CutsPiecesAndLonelyTiles) {
  Design design = dome();
  const TileMesh tiles = make_tile_mesh(design.mesh, design.cuts, 3);
  // All three edges of an inner tile: a component of its own without contacts.
  const int lonely = 20;
  design.cuts.resize(3, 2);
  for (int t = 0; t < 3; ++t) {
    ASSERT_GE(tiles.topology.neighbour(lonely, t), 0);
    design.cuts.row(t) << tiles.mesh.F(lonely, t), tiles.mesh.F(lonely, next3(t));
  }
  const VerificationReport r = verify_design(design, {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LT(r.physics.force_balance, 1e-6);
  EXPECT_LT(r.contact_forces.imbalance, 1e-9);
  EXPECT_EQ(r.solved->elastic.row(lonely).norm(), 0);
  EXPECT_TRUE(std::isnan(r.tile_normal_min(lonely)));
}

TEST(Verify, OneTileAndTwoTiles) {
  const TriangleMesh mesh = hexagon(1, test::cap_height);
  for (int count : {1, 2}) {
    TriangleMesh part = mesh;
    part.F = mesh.F.topRows(count);
    const VerificationReport r = verify_design(spread_design(part, 1.35, 1.2), {});
    EXPECT_TRUE(r.physics.converged);
    EXPECT_EQ(r.unilateral.status, SolveStatus::converged);
    EXPECT_EQ(r.contact_tiles.rows(), count - 1);
  }
}

// Walls meet where bumps sink into dimples: the interfaces' corners touch, not the tips.
TEST(Verify, TilesWithDimplesAreJudgedAtTheirWalls) {
  Design design = dome();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);
  design.parameters.bumps = "dimples";
  const BumpPlan plan = plan_bumps(geometry, poses, design.parameters);
  ASSERT_LT(plan.bare.size(), geometry.tiles.contacts.size());
  for (const Points3& tips : bump_tips(plan, geometry.tiles)) EXPECT_EQ(tips.rows(), 0);
  const VerificationReport dimples = verify_design(design, {});
  EXPECT_FALSE(dimples.unilateral.feasible_at_tips);
  ASSERT_TRUE(dimples.unilateral.sliding_play);
  // Rim to rim: a bump's sphere grown by the clearance, at the height of the wall.
  const double r = 2 * design.parameters.bump_height, h = design.parameters.bump_height,
               R = (r * r + h * h) / (2 * h), c = dimple_clearance;
  EXPECT_NEAR(*dimples.unilateral.sliding_play,
              std::sqrt((R + c) * (R + c) - (R - h) * (R - h)) - r, 0.3 * c);
  EXPECT_GT(*dimples.unilateral.sliding_play, c);
  // The membranes know nothing of it, and the walls' corners are those of plain walls.
  design.parameters.bumps = "none";
  const VerificationReport none = verify_design(design, {});
  EXPECT_EQ(dimples.unilateral.largest_floor, none.unilateral.largest_floor);
  EXPECT_EQ(dimples.contact_forces.normal_min, none.contact_forces.normal_min);
  EXPECT_FALSE(none.unilateral.sliding_play);
  // Without friction dimples stop the slip.
  design.parameters.bumps = "dimples";
  design.parameters.friction_coefficient = 0.01;
  design.parameters.gravity = "held";
  design.parameters.held_tiles = "T00001";
  const VerificationReport slippery = verify_design(design, {});
  ASSERT_EQ(slippery.unilateral.status, SolveStatus::infeasible);
  const Finding* unbalanced = find_kind(slippery.reasons, "no_balance");
  ASSERT_NE(unbalanced, nullptr);
  EXPECT_NE(
      find_kind(std::get<std::vector<Finding>>(unbalanced->figures.at("more")), "dimples_stop"),
      nullptr);
}

// The verdict is asked at the corners of interfaces; bumps' tips alone are a warning.
TEST(Verify, WhatOnlyTipsCannotHoldIsAWarning) {
  Design design = dome();
  const VerificationReport r = verify_design(design, {});
  ASSERT_TRUE(r.valid);
  EXPECT_EQ(r.unilateral.feasible_at_tips, true);
  // Heavy at one end: tips, nearer to one another than corners, lose first.
  design.parameters.gravity = "held";
  design.parameters.held_tiles = "T00001";
  VerificationReport heavy;
  for (double density = 2; density < 1e4; density *= 1.25) {
    design.parameters.density = density;
    heavy = verify_design(design, {});
    if (heavy.unilateral.feasible_at_tips == false) break;
    EXPECT_EQ(find_kind(heavy.warnings, "least_force.tips"), nullptr);
  }
  ASSERT_TRUE(heavy.unilateral.feasible);
  EXPECT_EQ(heavy.unilateral.feasible_at_tips, false);
  EXPECT_NE(find_kind(heavy.warnings, "least_force.tips"), nullptr);
  EXPECT_EQ(find_kind(heavy.reasons, "least_force"), nullptr);
  // Without bumps there is nothing to say.
  design.parameters.bumps = "none";
  EXPECT_FALSE(verify_design(design, {}).unilateral.feasible_at_tips.has_value());
}

TEST(Verify, TheErrorBehindFMinIsThatOfTheLeastForce) {
  Eigen::ArrayXd force(4), error(4);
  force << 1.0, 0.3, 0.35, 2.0;
  error << 0.01, 0.02, 0.2, 0.5;
  // The second point is the least, the third may be: 0.35 - 0.2.
  EXPECT_NEAR(error_of_least(force, error), 0.3 - 0.15, 1e-12);
  EXPECT_EQ(error_of_least(force, Eigen::ArrayXd::Zero(4)), 0);
  const VerificationReport r = verify_design(dome(), {});
  EXPECT_GT(r.physics.least_force_error, 0);
  EXPECT_LE(r.physics.least_force_error, r.physics.largest_normal_force_error + 1e-12);
  // Asked for less than that, f_min is the larger of the errors.
  Design design = dome();
  design.parameters.f_min_ratio = 1e-4;
  const VerificationReport low = verify_design(design, {});
  EXPECT_NEAR(low.contact_forces.f_min / low.contact_forces.normal_mean,
              std::max(low.physics.least_force_error, low.physics.normal_force_error), 1e-12);
}

// f_min just below the least force: the mesh does not tell whether that reaches it.
TEST(Verify, AWarningNamesContactsThatStayUndecided) {
  Design design = dome();
  VerificationReport r = verify_design(design, {});
  EXPECT_EQ(find_kind(r.warnings, "undecided"), nullptr);
  design.parameters.f_min_ratio =
      0.9999 * r.contact_forces.normal_min / r.contact_forces.normal_mean;
  r = verify_design(design, {});
  const Finding* undecided = find_kind(r.warnings, "undecided");
  ASSERT_NE(undecided, nullptr);
  EXPECT_EQ(r.contact_forces.points_below_f_min, 0);
  const Finding::Pairs contacts = std::get<Finding::Pairs>(undecided->figures.at("contacts"));
  double least = 1e9;
  for (int k = 0; k < r.contact_tiles.rows(); ++k) {
    const std::array<int, 2> pair = {r.contact_tiles(k, 0), r.contact_tiles(k, 1)};
    if (std::find(contacts.begin(), contacts.end(), pair) == contacts.end()) continue;
    least = std::min(least, r.contact_normal_min(k));
  }
  EXPECT_EQ(least, r.contact_forces.normal_min);
  EXPECT_LT(static_cast<int>(contacts.size()), r.contact_tiles.rows() / 2);
}

// Glue on a pin carries what the sheet pulls along its outline.
TEST(Verify, GlueIsLoadedAlongPinsAndSaidWhereItIsWeak) {
  Design design = dome();
  const VerificationReport r = verify_design(design, {});
  const GlueLoad& shear = r.glue.shear;
  ASSERT_GE(shear.tile, 0);
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const double* q = design.q.row(shear.tile).data();
  const auto corner = pin_corners(geometry.tiles, shear.tile, shear.side, q);
  double around = 0;
  for (int t = 0; t < 3; ++t) around += (corner[next3(t)] - corner[t]).norm();
  // A sheet stretched by 3 in both directions pulls with G h (1 - 3^-6) on every mm.
  const double even = 0.72 * 0.5 * (1 - std::pow(3.0, -6));
  const double area = pin_area(geometry.tiles, shear.tile, shear.side, q);
  EXPECT_GT(shear.shear, 0.5 * even * around / area);
  EXPECT_LT(shear.shear, 2.0 * even * around / area);
  EXPECT_GT(r.glue.peel.peel, 0);
  EXPECT_LT(r.glue.peel.peel, 2 * even);
  EXPECT_EQ(find_kind(r.warnings, "glue_shear"), nullptr);
  EXPECT_EQ(find_kind(r.warnings, "sheet_tears"), nullptr);
  design.parameters.glue_strength = 0.999 * shear.shear;
  design.parameters.elongation_at_break = 100 * (r.physics.stretch_99 - 1) - 1;
  const VerificationReport weak = verify_design(design, {});
  const Finding* warning = find_kind(weak.warnings, "glue_shear");
  ASSERT_NE(warning, nullptr);
  EXPECT_TRUE(std::binary_search(warning->tiles.begin(), warning->tiles.end(), shear.tile));
  EXPECT_LT(static_cast<int>(warning->tiles.size()), geometry.tiles.tile_count());
  EXPECT_EQ(std::get<double>(warning->figures.at("shear")), shear.shear);
  EXPECT_EQ(std::get<double>(warning->figures.at("limit")), design.parameters.glue_strength);
  EXPECT_NE(find_kind(weak.warnings, "sheet_tears"), nullptr);
  EXPECT_TRUE(weak.valid);  // a warning
}

TEST(Verify, AMembraneThatCutsIntoABodyIsNotValid) {
  // A sharp ridge with pins far behind it.
  const TriangleMesh ridge = hexagon(2, [](double x, double) { return -0.8 * std::abs(x); });
  const VerificationReport r = verify_design(spread_design(ridge, 1.5, 1.6), {});
  EXPECT_LT(r.physics.clearance_mm, 0);
  EXPECT_FALSE(r.valid);
  EXPECT_NE(find_kind(r.reasons, "membrane.cuts"), nullptr);
  EXPECT_GT(verify_design(dome(), {}).physics.clearance_mm, 0.3);
}

TEST(Verify, OfTilesAsNearTheLastIsNamed) {
  const std::vector<MembraneClearance> nearly_equal = {
      {0.5, 3}, {0.2 - 1e-12, 8}, {0.2, 7}, {1.2, -1}};
  EXPECT_EQ(least_clearance(nearly_equal, 1.2).tile, 7);
  EXPECT_EQ(least_clearance(nearly_equal, 1.2).distance, 0.2 - 1e-12);
  EXPECT_EQ(least_clearance({{0.2, 7}, {0.1, 8}}, 1.2).tile, 8);
  EXPECT_EQ(least_clearance({{1.2, -1}}, 1.2).tile, -1);
}

TEST(Verify, IsTheSameWithOneThreadAndTwo) {
  const int threads = thread_count();
  set_thread_count(1);
  const VerificationReport one = verify_design(dome(), {});
  set_thread_count(2);
  const VerificationReport two = verify_design(dome(), {});
  set_thread_count(threads);
  EXPECT_EQ((one.solved->elastic - two.solved->elastic).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(one.unilateral.largest_floor, two.unilateral.largest_floor);
  EXPECT_EQ(one.contact_forces.normal_min, two.contact_forces.normal_min);
  EXPECT_EQ(one.physics.clearance_mm, two.physics.clearance_mm);
  EXPECT_EQ(one.reasons, two.reasons);
}

TEST(Verify, WeakPointsAreEnoughWhereNoMoreIsAskedFor) {
  Design design = dome();
  const VerificationReport valid = verify_design(design, {}, {true});
  EXPECT_TRUE(valid.complete && valid.valid);
  const ContactFigures& forces = valid.contact_forces;
  design.parameters.f_min_ratio = 1.1 * forces.normal_min / forces.normal_mean;
  const VerificationReport brief = verify_design(design, {}, {true});
  EXPECT_FALSE(brief.complete);
  EXPECT_FALSE(brief.valid);
  EXPECT_GT(brief.contact_forces.points_below_f_min, 0);
  const VerificationReport whole = verify_design(design, {});
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(brief.contact_forces.invalid_contacts, whole.contact_forces.invalid_contacts);
  EXPECT_EQ(brief.contact_normal_min, whole.contact_normal_min);
}

}  // namespace
}  // namespace curveups
