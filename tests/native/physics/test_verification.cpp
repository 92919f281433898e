// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/physics/design_forces.hpp"
#include "curveups/physics/loosening.hpp"
#include "curveups/physics/touch_points.hpp"
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
  const VerificationReport r = verify_design(dome(), {}, {});
  EXPECT_TRUE(r.computed);
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LE(r.physics.fine_iterations[0], 20);
  EXPECT_LE(r.physics.fine_iterations[1], 20);
  EXPECT_LT(r.physics.force_balance, 1e-9);
  EXPECT_LT(r.physics.torque_balance, 1e-9);
  EXPECT_LT(r.contact_forces.imbalance, 1e-9);
  EXPECT_GT(r.contact_forces.normal_mean, 0);
  EXPECT_EQ(r.unilateral.status, SolveStatus::converged);
  EXPECT_TRUE(r.valid);
  EXPECT_TRUE(r.reasons.empty());
}

TEST(Verify, ForcesAreProportionalToStiffness) {
  Design design = dome();
  const VerificationReport a = verify_design(design, {}, {});
  for (double* m : {&design.parameters.shear_modulus_front, &design.parameters.shear_modulus_back})
    *m *= 3;
  design.parameters.glue_strength *= 3;
  const VerificationReport b = verify_design(design, {}, {});
  EXPECT_LT((3 * a.elastic - b.elastic).cwiseAbs().maxCoeff(),
            1e-6 * b.elastic.cwiseAbs().maxCoeff());
  EXPECT_NEAR(b.contact_forces.normal_mean / a.contact_forces.normal_mean, 3, 1e-6);
  EXPECT_EQ(a.valid, b.valid);
  // Different membranes: neither of both.
  design.parameters.shear_modulus_back /= 3;
  const VerificationReport c = verify_design(design, {}, {});
  EXPECT_TRUE(c.physics.converged);
  EXPECT_GT(c.contact_forces.normal_mean, a.contact_forces.normal_mean);
  EXPECT_LT(c.contact_forces.normal_mean, b.contact_forces.normal_mean);
}

TEST(Verify, SmallerTrianglesMoveForcesByLessThanTheStatedError) {
  Design design = dome();
  const VerificationReport coarse = verify_design(design, {}, {});
  design.parameters.mesh_size = 0.2;
  const VerificationReport fine = verify_design(design, {}, {});
  EXPECT_LT(fine.physics.normal_force_error, coarse.physics.normal_force_error);
  EXPECT_LT(coarse.physics.normal_force_error, 0.015);
  double mean = 0;
  for (int k = 0; k < fine.contact_normal_mean.size(); ++k) {
    mean += std::abs(fine.contact_normal_mean(k) - coarse.contact_normal_mean(k)) /
            fine.contact_normal_mean.size();
  }
  EXPECT_LT(mean / fine.contact_forces.normal_mean, coarse.physics.normal_force_error);
}

TEST(Verify, ALooseLayoutWithWrinklesConverges) {
  const VerificationReport r =
      verify_design(spread_design(hexagon(3, test::cap_height), 1.9, 1.2), {}, {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LE(r.physics.fine_iterations[0], 20);
  EXPECT_LE(r.physics.fine_iterations[1], 20);
  EXPECT_LT(r.physics.force_balance, 1e-9);
}

TEST(Verify, WithoutStretchTheMembranesGoSlackAndNothingIsValid) {
  Design design = dome();
  design.parameters.tau = 1.05;
  const VerificationReport r = verify_design(design, {}, {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_GT(r.physics.slack_fraction + r.physics.wrinkled_fraction, 0.3);
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
  const VerificationReport r = verify_design(design, {}, {});
  EXPECT_TRUE(r.physics.converged);
  EXPECT_LT(r.physics.force_balance, 1e-9);
  EXPECT_LT(r.contact_forces.imbalance, 1e-9);
  EXPECT_EQ(r.elastic.row(lonely).norm(), 0);
  EXPECT_TRUE(std::isnan(r.tile_normal_min(lonely)));
}

TEST(Verify, OneTileAndTwoTiles) {
  const TriangleMesh mesh = hexagon(1, test::cap_height);
  for (int count : {1, 2}) {
    TriangleMesh part = mesh;
    part.F = mesh.F.topRows(count);
    const VerificationReport r = verify_design(spread_design(part, 1.35, 1.2), {}, {});
    EXPECT_TRUE(r.physics.converged);
    EXPECT_EQ(r.unilateral.status, SolveStatus::converged);
    EXPECT_EQ(r.contact_tiles.rows(), count - 1);
  }
}

// Where tips stand at the interfaces' corners they hold what corners hold.
TEST(Verify, BumpTipsAreContactPoints) {
  const Design design = dome();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const SolvedDesign solved = solve_design(geometry, design, {});
  const std::vector<ContactPoint> points = contact_corners(geometry, design.parameters);
  std::vector<Points3> corners, middle;
  for (const ContactPatch& patch : geometry.patches) {
    Points3 at(patch.point_count, 3);
    for (int l = 0; l < patch.point_count; ++l) at.row(l) = patch.point[l].transpose();
    corners.push_back(at);
    middle.push_back(at.colwise().mean());
  }
  auto solve = [&](const std::vector<Points3>& tips) {
    BalanceSystem system =
        make_balance_system(geometry, design.parameters, tie_to_corners(points, tips).points);
    UnilateralOptions options;
    options.friction_coefficient = design.parameters.friction_coefficient;
    options.scale = solved.forces.normal_mean;
    const ContactForces start = solve_contact_forces(system, solved.loads);
    return solve_unilateral(system, solved.loads, start.force, options);
  };
  const VerificationReport r = verify_design(design, {}, {});
  const UnilateralResult at_corners = solve(corners);
  EXPECT_EQ(at_corners.solve.status, r.unilateral.status);
  EXPECT_NEAR(at_corners.largest_floor, r.unilateral.largest_floor, 1e-6);
  // A single point each can't hold the tiles' torques.
  EXPECT_NE(solve(middle).solve.status, SolveStatus::converged);
  // Contacts without tips touch at their corners.
  const std::vector<Points3> none(corners.size(), Points3(0, 3));
  EXPECT_EQ(tie_to_corners(points, none).points.size(), points.size());
}

// Verification asks the bodies itself where printed tiles touch.
TEST(Verify, TilesWithBumpsAreJudgedAtTheirTips) {
  Design design = dome();
  const VerificationReport bumps = verify_design(design, {}, {});
  ASSERT_TRUE(bumps.unilateral.tips_status);
  EXPECT_EQ(*bumps.unilateral.tips_status, SolveStatus::converged);
  design.parameters.bumps = "none";
  EXPECT_FALSE(verify_design(design, {}, {}).unilateral.tips_status);
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
  const VerificationReport dimples = verify_design(design, {}, {});
  EXPECT_FALSE(dimples.unilateral.tips_status);
  ASSERT_TRUE(dimples.unilateral.sliding_play);
  // Rim to rim: a bump's sphere grown by the clearance, at the height of the wall.
  const double r = 2 * design.parameters.bump_height, h = design.parameters.bump_height,
               R = (r * r + h * h) / (2 * h), c = dimple_clearance;
  EXPECT_NEAR(*dimples.unilateral.sliding_play,
              std::sqrt((R + c) * (R + c) - (R - h) * (R - h)) - r, 0.3 * c);
  EXPECT_GT(*dimples.unilateral.sliding_play, c);
  // The membranes know nothing of it, and the walls' corners are those of plain walls.
  design.parameters.bumps = "none";
  const VerificationReport none = verify_design(design, {}, {});
  EXPECT_EQ(dimples.unilateral.largest_floor, none.unilateral.largest_floor);
  EXPECT_EQ(dimples.contact_forces.normal_min, none.contact_forces.normal_min);
  EXPECT_FALSE(none.unilateral.sliding_play);
  // What slides apart without friction is said to be stopped by them.
  design.parameters.bumps = "dimples";
  design.parameters.friction_coefficient = 0.01;
  design.parameters.gravity = "held";
  design.parameters.held_tiles = "T00001";
  const VerificationReport slippery = verify_design(design, {}, {});
  ASSERT_EQ(slippery.unilateral.status, SolveStatus::infeasible);
  const Finding* unbalanced = find_kind(slippery.reasons, "no_balance");
  ASSERT_NE(unbalanced, nullptr);
  EXPECT_NE(
      find_kind(std::get<std::vector<Finding>>(unbalanced->figures.at("more")), "dimples_stop"),
      nullptr);
}

// The floor at tips is that at corners: f_min, and a design that only balances there is not valid.
TEST(Verify, TipsHaveToPressAsCornersDo) {
  Design design = dome();
  const VerificationReport r = verify_design(design, {}, {});
  ASSERT_TRUE(r.valid);
  EXPECT_TRUE(r.unilateral.feasible_at_tips);
  // Heavy at one end: tips, nearer to one another than corners, lose first.
  design.parameters.gravity = "held";
  design.parameters.held_tiles = "T00001";
  bool found = false;
  for (double density = 2; density < 1e4 && !found; density *= 1.25) {
    design.parameters.density = density;
    const VerificationReport heavy = verify_design(design, {}, {});
    const UnilateralFigures& u = heavy.unilateral;
    EXPECT_EQ(u.feasible_at_tips, *u.tips_status == SolveStatus::converged &&
                                      u.tips_largest_floor >= u.floor - 1e-3 * u.floor);
    bool at_tips = false;
    for (const Finding& reason : heavy.reasons) {
      at_tips |= reason.kind == "least_force.tips" || reason.kind == "no_balance.tips" ||
                 reason.kind == "balance_unknown.tips";
    }
    EXPECT_EQ(at_tips, !u.feasible_at_tips);
    found = u.feasible && !u.feasible_at_tips;
    EXPECT_FALSE(found && heavy.valid);
  }
  EXPECT_TRUE(found);
}

TEST(Verify, TheErrorBehindFMinIsThatOfTheLeastForce) {
  Eigen::ArrayXd force(4), error(4);
  force << 1.0, 0.3, 0.35, 2.0;
  error << 0.01, 0.02, 0.2, 0.5;
  // The second point is the least, the third may be: 0.35 - 0.2.
  EXPECT_NEAR(error_of_least(force, error), 0.3 - 0.15, 1e-12);
  EXPECT_EQ(error_of_least(force, Eigen::ArrayXd::Zero(4)), 0);
  const VerificationReport r = verify_design(dome(), {}, {});
  EXPECT_GT(r.physics.least_force_error, 0);
  EXPECT_LE(r.physics.least_force_error, r.physics.largest_normal_force_error + 1e-12);
  // Asked for less than that, f_min is the larger of the errors.
  Design design = dome();
  design.parameters.f_min_ratio = 1e-4;
  const VerificationReport low = verify_design(design, {}, {});
  EXPECT_NEAR(low.contact_forces.f_min / low.contact_forces.normal_mean,
              std::max(low.physics.least_force_error, low.physics.normal_force_error), 1e-12);
}

// f_min just below the least force: the mesh alone does not tell whether that reaches it.
TEST(Verify, TheMeshIsRefinedWhereALeastForceIsNotDecided) {
  Design design = dome();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  auto solve = [&](double f_min_ratio, double mesh_size) {
    Design other = design;
    other.parameters.f_min_ratio = f_min_ratio;
    other.parameters.mesh_size = mesh_size;
    return solve_design(geometry, other, {});
  };
  const double h = design.parameters.mesh_size;
  const SolvedDesign plain = solve(0.1, h), fine = solve(0.1, h / 4);
  EXPECT_TRUE(plain.halvings.empty() && plain.undecided.empty());
  const int weakest = plain.forces.weakest_point;
  const double least = plain.forces.normal_min / plain.forces.normal_mean;
  ASSERT_GT(least, 0.1 + plain.least_force_error);
  const double close = least - 0.5 * plain.least_force_error;
  const SolvedDesign refined = solve(close, h);
  const auto untouched = std::count(refined.halvings.begin(), refined.halvings.end(), 0);
  EXPECT_GT(untouched, geometry.tiles.tile_count() / 2);
  EXPECT_LT(untouched, geometry.tiles.tile_count() - 4);
  const double truth = fine.forces.force(weakest, 0);
  EXPECT_LT(std::abs(refined.forces.force(weakest, 0) - truth),
            refined.least_force_error * refined.forces.normal_mean);
  EXPECT_LT(refined.least_force_error, 0.8 * plain.least_force_error);
  // Balance needs no particular mesh.
  EXPECT_LT(refined.forces.imbalance, 1e-9);
  // Points below f_min decide by themselves: nothing is refined.
  EXPECT_TRUE(solve(1.05 * least, h).halvings.empty());
  // Where f_min is the error itself, the mesh decides on what is asked for and below that.
  design.parameters.thickness_front = 0.885;
  const SolvedDesign low = solve(1e-4, h);
  EXPECT_GT(low.forces.normal_min, 1e-4 * low.forces.normal_mean);
  EXPECT_LT(low.forces.normal_min, plain.normal_force_error * low.forces.normal_mean);
  EXPECT_FALSE(low.halvings.empty());
  // Pins that let go leave the sizes of the mesh as they are.
  const LoosePins one = {std::vector<int>{20}, {}};
  const SolvedDesign without = solve_without_pins(geometry, refined, one, {});
  EXPECT_EQ(without.halvings, refined.halvings);
  EXPECT_GE(without.membranes[1].mesh.triangles.size(), refined.membranes[1].mesh.triangles.size());
}

TEST(Verify, AWarningNamesContactsThatStayUndecided) {
  Design design = dome();
  VerificationReport r = verify_design(design, {}, {});
  EXPECT_EQ(r.physics.refined_tiles, 0);
  EXPECT_EQ(find_kind(r.warnings, "undecided"), nullptr);
  // From f_min a little below the least force of the mesh that this leads to.
  for (int round = 0; round < 6 && !find_kind(r.warnings, "undecided"); ++round) {
    design.parameters.f_min_ratio =
        0.9999 * r.contact_forces.normal_min / r.contact_forces.normal_mean;
    r = verify_design(design, {}, {});
  }
  const Finding* undecided = find_kind(r.warnings, "undecided");
  ASSERT_NE(undecided, nullptr);
  EXPECT_GT(r.physics.refined_tiles, 4);
  EXPECT_EQ(r.contact_forces.points_below_f_min, 0);
  const Finding::Pairs contacts = std::get<Finding::Pairs>(undecided->figures.at("contacts"));
  double least = 1e9;
  for (int k = 0; k < r.contact_tiles.rows(); ++k) {
    const std::array<int, 2> pair = {r.contact_tiles(k, 0), r.contact_tiles(k, 1)};
    if (std::find(contacts.begin(), contacts.end(), pair) == contacts.end()) continue;
    least = std::min(least, r.contact_normal_min(k));
  }
  EXPECT_EQ(least, r.contact_forces.normal_min);
}

// Glue on a pin carries what the sheet pulls along its outline.
TEST(Verify, GlueIsLoadedAlongPinsAndSaidWhereItIsWeak) {
  Design design = dome();
  const VerificationReport r = verify_design(design, {}, {});
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
  EXPECT_EQ(find_kind(r.warnings, "glue_shear.holds"), nullptr);
  EXPECT_EQ(r.loosening.rounds, 0);
  EXPECT_EQ(find_kind(r.warnings, "sheet_tears"), nullptr);
  design.parameters.glue_strength = 0.999 * shear.shear;
  design.parameters.elongation_at_break = 100 * (r.physics.stretch_99 - 1) - 1;
  const VerificationReport weak = verify_design(design, {}, {});
  EXPECT_NE(find_kind(weak.warnings, "glue_shear.holds"), nullptr);
  EXPECT_NE(find_kind(weak.warnings, "sheet_tears"), nullptr);
  EXPECT_TRUE(weak.valid);  // a warning
}

// A pin in the middle of a larger dome lets go: the tiles around it hold that one.
TEST(Verify, PinsWhoseGlueFailsLetGoAndThePieceIsJudgedWithoutThem) {
  const Design design = dome();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const SolvedDesign solved = solve_design(geometry, design, {});
  const LoosePins one = {std::vector<int>{20}, {}};
  const Loosening loose = loosen_pins(geometry, solved, one, {}, {});
  EXPECT_EQ(loose.pins, one);
  EXPECT_EQ(loose.rounds, 1);
  EXPECT_TRUE(loose.holds);
  ASSERT_TRUE(loose.largest_floor);
  EXPECT_GE(*loose.largest_floor, loose.f_min);
  // The front membrane pulls at its tile no more, and all forces still balance.
  const SolvedDesign without = solve_without_pins(geometry, solved, one, {});
  const Points3& forces = without.membranes[0].forces;
  EXPECT_EQ(forces.middleRows<3>(60).norm(), 0);
  EXPECT_GT(solved.membranes[0].forces.middleRows<3>(60).norm(), 0.1);
  EXPECT_TRUE(without.membranes[0].state.solve.converged());
  const WrenchBalance balance =
      wrench_balance(without.elastic, tile_centres(geometry.tiles), design.parameters.L);
  EXPECT_LT(balance.force, 1e-9);
  EXPECT_LT(balance.torque, 1e-9);
  // The sheet above the pin is a part of what is stretched there.
  EXPECT_GT(measure_areas(without.membranes[0]).all, measure_areas(solved.membranes[0]).all);
}

// All pins of a side but one, or all: rounding must not decide whether that has a solution.
TEST(Verify, APieceWhoseMembranesComeOffDoesNotHold) {
  const Design design = dome();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const SolvedDesign solved = solve_design(geometry, design, {});
  const std::vector<int> none;
  std::vector<int> all, most;
  for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
    all.push_back(i);
    if (i != 20) most.push_back(i);
  }
  for (const LoosePins& pins : {LoosePins{all, none}, LoosePins{none, all}, LoosePins{all, all}}) {
    const Loosening loose = loosen_pins(geometry, solved, pins, {}, {});
    EXPECT_EQ(loose.pins, pins);
    EXPECT_EQ(loose.rounds, 1);
    EXPECT_FALSE(loose.holds);
    EXPECT_FALSE(loose.largest_floor);
  }
  EXPECT_FALSE(loosen_pins(geometry, solved, {most, most}, {}, {}).holds);
}

TEST(Verify, GlueThatCarriesNothingHasALimit) {
  GlueLoads idle;
  idle[0] = {{0, Side::front, 0, 0, 0.7}};
  EXPECT_EQ(largest_of(idle).shear.limit, 0.7);
  EXPECT_EQ(overloaded_pins(idle), LoosePins());
}

TEST(Verify, GlueThatFailsAllAlongIsAReason) {
  Design design = dome();
  design.parameters.glue_strength = 0.01;
  const VerificationReport r = verify_design(design, {}, {});
  EXPECT_FALSE(r.valid);
  EXPECT_FALSE(r.loosening.holds);
  EXPECT_FALSE(r.loosening.largest_floor);
  EXPECT_NE(find_kind(r.reasons, "glue_shear.all"), nullptr);
}

TEST(Verify, AMembraneThatCutsIntoABodyIsNotValid) {
  // A sharp ridge with pins far behind it.
  const TriangleMesh ridge = hexagon(2, [](double x, double) { return -0.8 * std::abs(x); });
  const VerificationReport r = verify_design(spread_design(ridge, 1.5, 1.6), {}, {});
  EXPECT_LT(r.physics.clearance_mm, 0);
  EXPECT_FALSE(r.valid);
  EXPECT_NE(find_kind(r.reasons, "membrane.cuts"), nullptr);
  EXPECT_GT(verify_design(dome(), {}, {}).physics.clearance_mm, 0.3);
}

TEST(Verify, OfPlacesAsNearTheLastIsNamed) {
  const std::vector<MembraneClearance> by_digits = {
      {0.5, 3, 0}, {0.2 - 1e-12, 8, 1}, {0.2, 7, 2}, {1.2, -1, 3}};
  EXPECT_EQ(least_clearance(by_digits, 1.2).tile, 7);
  EXPECT_EQ(least_clearance(by_digits, 1.2).distance, 0.2 - 1e-12);
  EXPECT_EQ(least_clearance({{0.2, 7, 1}, {0.1, 8, 2}}, 1.2).tile, 8);
  EXPECT_EQ(least_clearance({{1.2, -1, 0}}, 1.2).patch, -1);
}

TEST(Verify, IsTheSameWithOneThreadAndTwo) {
  const int threads = thread_count();
  set_thread_count(1);
  const VerificationReport one = verify_design(dome(), {}, {});
  // On a mesh that is refined in places, with pins that let go.
  Design hard = dome();
  hard.parameters.f_min_ratio =
      0.999 * one.contact_forces.normal_min / one.contact_forces.normal_mean;
  hard.parameters.glue_strength = 0.999 * verify_design(hard, {}, {}).glue.shear.shear;
  const VerificationReport hard_one = verify_design(hard, {}, {});
  set_thread_count(2);
  const VerificationReport two = verify_design(dome(), {}, {}),
                           hard_two = verify_design(hard, {}, {});
  set_thread_count(threads);
  EXPECT_GT(hard_one.physics.refined_tiles, 4);
  EXPECT_GE(hard_one.loosening.rounds, 1);
  ASSERT_TRUE(hard_one.loosening.largest_floor);
  EXPECT_EQ(hard_one.loosening.largest_floor, hard_two.loosening.largest_floor);
  EXPECT_EQ(hard_one.loosening.pins, hard_two.loosening.pins);
  EXPECT_EQ((hard_one.elastic - hard_two.elastic).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(hard_one.contact_forces.normal_min, hard_two.contact_forces.normal_min);
  EXPECT_EQ(hard_one.reasons, hard_two.reasons);
  EXPECT_EQ(hard_one.warnings, hard_two.warnings);
  EXPECT_EQ((one.elastic - two.elastic).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(one.unilateral.largest_floor, two.unilateral.largest_floor);
  EXPECT_EQ(one.contact_forces.normal_min, two.contact_forces.normal_min);
  EXPECT_EQ(one.physics.clearance_mm, two.physics.clearance_mm);
  EXPECT_EQ(one.reasons, two.reasons);
}

TEST(Verify, WeakPointsAreEnoughWhereNoMoreIsAskedFor) {
  Design design = dome();
  const VerificationReport valid = verify_design(design, {}, {}, {true});
  EXPECT_TRUE(valid.complete && valid.valid);
  const ContactFigures& forces = valid.contact_forces;
  design.parameters.f_min_ratio = 1.1 * forces.normal_min / forces.normal_mean;
  SolutionStore store;
  const VerificationReport brief = verify_design(design, &store, {}, {true});
  EXPECT_FALSE(brief.complete);
  EXPECT_FALSE(brief.valid);
  EXPECT_GT(brief.contact_forces.points_below_f_min, 0);
  // What was solved is left for the verdict, which is the same.
  const VerificationReport after = verify_design(design, &store, {}),
                           alone = verify_design(design, {}, {});
  EXPECT_TRUE(after.complete && alone.complete);
  EXPECT_EQ(after.reasons, alone.reasons);
  EXPECT_EQ(after.elastic, alone.elastic);
  EXPECT_EQ(after.unilateral.largest_floor, alone.unilateral.largest_floor);
  EXPECT_EQ(brief.contact_forces.invalid_contacts, alone.contact_forces.invalid_contacts);
  EXPECT_EQ(brief.contact_normal_min, alone.contact_normal_min);
}

TEST(Verify, LeavesWhatRepairStartsFrom) {
  const Design design = dome();
  SolutionStore store;
  const VerificationReport r = verify_design(design, &store, {});
  std::optional<SolvedDesign> left = store.take(design);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->loads, r.elastic);
  EXPECT_EQ(left->f_min_ratio, design.parameters.f_min_ratio);
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);
  const DesignForces fresh = test::solve_forces(geometry, design.parameters, poses, design.q);
  DesignForces kept(geometry, design.parameters,
                    {std::move(left->membranes[0].coarse), std::move(left->membranes[1].coarse)},
                    poses, design.q);
  EXPECT_EQ(kept.contact_forces().force, fresh.contact_forces().force);
  // It follows other poses and insets as a fresh one does.
  const Array6 q = design.q.array() + 0.01;
  kept.move(geometry, poses, q, {});
  EXPECT_LT((kept.contact_forces().force - fresh.contact_forces().force).norm(),
            0.1 * fresh.contact_forces().force.norm());
}

// Membranes of another design, or of one whose owner has used them up, must never be judged.
TEST(SolutionStore, ServesOnceAndOnlyTheVeryDesign) {
  const Design design = dome();
  SolutionStore store;
  const VerificationReport first = verify_design(design, &store, {});
  auto refuses = [&](const char* what, auto change) {
    Design other = design;
    change(other);
    EXPECT_FALSE(store.take(other)) << what;
  };
  refuses("layout", [](Design& d) { d.T(0, 0) += 1e-9; });
  refuses("pins", [](Design& d) { d.q(0, 0) += 1e-9; });
  refuses("vertices", [](Design& d) { d.mesh.V(0, 0) += 1e-9; });
  refuses("stretch", [](Design& d) { d.parameters.tau = 2.9; });
  refuses("modulus", [](Design& d) { d.parameters.shear_modulus_back *= 2; });
  refuses("gravity", [](Design& d) { d.parameters.gravity = "held"; });
  refuses("cuts", [](Design& d) {
    d.cuts.resize(1, 2);
    d.cuts << d.mesh.F(20, 0), d.mesh.F(20, 1);
  });
  // Another stretch is another verdict, whatever the store holds.
  Design looser = design;
  looser.parameters.tau = 2;
  const VerificationReport served = verify_design(looser, &store, {});
  EXPECT_EQ(served.elastic, verify_design(looser, {}, {}).elastic);
  EXPECT_NE(served.elastic, first.elastic);
  ASSERT_TRUE(store.take(looser));
  EXPECT_FALSE(store.take(looser));
  const VerificationReport again = verify_design(looser, &store, {});
  EXPECT_EQ(again.elastic, served.elastic);
  store.clear();
  EXPECT_FALSE(store.take(looser));
}

TEST(Verify, StopsWhenAskedTo) {
  EXPECT_THROW(verify_design(dome(), {}, [](const std::string&, double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace curveups
