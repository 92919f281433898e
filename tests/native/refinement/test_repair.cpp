// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/layout/layout.hpp"
#include "curveups/physics/friction_needed.hpp"
#include "curveups/physics/verification.hpp"
#include "curveups/refinement/repair.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

Design laid_out(const TriangleMesh& mesh) {
  Design design;
  design.name = "sample";
  design.mesh = mesh;
  design.cuts.resize(0, 2);
  const DesignGeometry geometry = make_geometry(mesh, design.cuts, design.parameters);
  const LayoutResult layout = solve_layout(geometry, design.parameters, {});
  design.T = flat_corners(geometry.tiles, layout.poses);
  design.q = layout.q;
  return design;
}

const Design& dome_design() {
  static const Design design = laid_out(test::dome(6));
  return design;
}

void expect_constraints_kept(const Design& design) {
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  const ConstraintReport report =
      check_constraints(geometry, design.T, design.q, design.parameters);
  EXPECT_LE(report.max_gap_violation_mm, tolerance::constraint);
  EXPECT_LE(report.max_pin_bound_violation_mm, tolerance::constraint);
  EXPECT_LE(report.max_pin_area_violation_mm2, 10 * tolerance::constraint);
  EXPECT_LE(report.max_rigidity_mm, 1e-9);
  EXPECT_TRUE(report.close_pairs.empty());
}

int weak_points(const Design& design) {
  return verify_design(design, {}).contact_forces.points_below_f_min;
}

// Pin drawn in to its limits, on both sides.
Design with_weakened_pin(int tile) {
  Design design = dome_design();
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  for (Side side : {Side::front, Side::back}) {
    const int first = inset_index(side, 0);
    double* q = design.q.row(tile).data();
    while (pin_area(geometry.tiles, tile, side, q) >
           1.1 * geometry.pin_bounds.least_area(tile, static_cast<int>(side))) {
      for (int t = 0; t < 3; ++t) {
        q[first + t] = std::min(q[first + t] + 0.01, geometry.pin_bounds.upper(tile, first + t));
      }
    }
  }
  return design;
}

// A weakened pin, and a floor that its weakest points just miss.
Design with_weak_contacts() {
  Design design = with_weakened_pin(20);
  const ContactFigures figures = verify_design(design, {}).contact_forces;
  design.parameters.f_min_ratio = 1.3 * figures.normal_min / figures.normal_mean;
  return design;
}

TEST(Repair, LeavesAValidDesignAsItIs) {
  const Design& design = dome_design();
  const RepairResult result = repair_design(design, {});
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  EXPECT_EQ(result.design.T, design.T);
  EXPECT_EQ(result.design.q, design.q);
  EXPECT_EQ(result.steps.size(), 1u);
}

TEST(Repair, LiftsWeakContactsAboveAHigherFloor) {
  const Design design = with_weak_contacts();
  ASSERT_GT(weak_points(design), 0);
  const RepairResult result = repair_design(design, {});
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  EXPECT_TRUE(result.steps.front().fresh_mesh);
  EXPECT_TRUE(result.steps.back().fresh_mesh);
  EXPECT_GT(result.steps.front().weak_points, 0);
  EXPECT_GT(result.largest_move, 0);
  expect_constraints_kept(result.design);
  const VerificationReport fresh = verify_design(result.design, {});
  EXPECT_EQ(fresh.contact_forces.points_below_f_min, 0);
  // The verdict on the last fresh mesh is that of verification.
  ASSERT_TRUE(result.verification);
  EXPECT_EQ(result.verification->solved->elastic, fresh.solved->elastic);
  EXPECT_EQ(result.verification->unilateral.largest_floor, fresh.unilateral.largest_floor);
  EXPECT_EQ(result.verification->valid, fresh.valid);
}

TEST(Repair, RestoresSpoiledPinsAndPoses) {
  Design design = dome_design();
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < design.q.rows(); ++i) {
    const double dx = 0.05 * uniform(generator), dy = 0.05 * uniform(generator);
    for (int k = 0; k < 6; ++k) {
      design.q(i, k) += 0.3 * uniform(generator);
      design.T(i, k) += k % 2 == 0 ? dx : dy;
    }
  }
  const RepairResult result = repair_design(design, {});
  EXPECT_GT(result.restored_mm, 0.01);
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  expect_constraints_kept(result.design);
  EXPECT_EQ(weak_points(result.design), 0);
}

const Design& small_dome() {
  static const Design design = laid_out(test::dome(4));
  return design;
}

// A floor on normal forces that poses and pins alone can't reach.
Design with_a_high_floor() {
  Design design = small_dome();
  const ContactFigures figures = verify_design(design, {}).contact_forces;
  design.parameters.f_min_ratio = 1.4 * figures.normal_min / figures.normal_mean;
  return design;
}

TEST(Repair, MovesVerticesWherePosesAndPinsDoNotDo) {
  const Design design = with_a_high_floor();
  const RepairResult result = repair_design(design, {});
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  EXPECT_GT(result.largest_vertex_move, 0.01);
  EXPECT_LT(result.largest_vertex_move, 0.2 * design.parameters.L);
  ASSERT_TRUE(result.design.target.has_value());
  EXPECT_EQ(result.design.target->V, design.mesh.V);
  expect_constraints_kept(result.design);
  EXPECT_TRUE(verify_design(result.design, {}).valid);
  // Half the mesh size tells the same.
  Design finer = result.design;
  finer.parameters.mesh_size *= 0.5;
  EXPECT_EQ(weak_points(finer), 0);
}

TEST(Repair, LiftsTheFloorOfTheUnilateralProblem) {
  Design design = laid_out(test::saddle(4));
  // The friction that is only just not enough.
  VerificationReport before;
  double& friction = design.parameters.friction_coefficient;
  for (friction = 0.12; friction > 0.05; friction -= 0.005) {
    before = verify_design(design, {});
    if (!before.unilateral.feasible) break;
  }
  ASSERT_FALSE(before.unilateral.feasible);
  ASSERT_EQ(before.contact_forces.points_below_f_min, 0);
  const RepairResult result = repair_design(design, {});
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  EXPECT_LT(result.steps.front().least_floor, 1);
  EXPECT_GE(result.steps.back().least_floor, 1);
  expect_constraints_kept(result.design);
  EXPECT_TRUE(verify_design(result.design, {}).unilateral.feasible);
}

TEST(Repair, DrawsPinsOutWhereAMembraneCutsIntoABody) {
  Design design = laid_out(test::dome(4, 7, 25));
  design.parameters.H_pin = 0.5;
  const VerificationReport before = verify_design(design, {});
  ASSERT_LT(before.physics.clearance_mm, 0);
  const RepairResult result = repair_design(design, {});
  EXPECT_EQ(result.solve.status, SolveStatus::converged);
  expect_constraints_kept(result.design);
  EXPECT_GT(verify_design(result.design, {}).physics.clearance_mm, 0);
}

TEST(Repair, SaysWhatBlocksTheImpossible) {
  Design design = small_dome();
  design.parameters.f_min_ratio = 0.95;  // all points nearly alike: no dome does that
  const RepairResult result = repair_design(design, {}, {}, 3);
  EXPECT_EQ(result.solve.status, SolveStatus::unfinished);
  ASSERT_FALSE(result.blocked.empty());
  for (const BlockedContact& contact : result.blocked) {
    EXPECT_LT(std::get<double>(contact.reason.figures.at("share")), 1);
    EXPECT_EQ(contact.reason.tiles, tiles_of({contact.tiles}));
  }
  expect_constraints_kept(result.design);
}

TEST(Repair, StoppedItKeepsTheBestSoFar) {
  const Design design = with_weak_contacts();
  int calls = 0;
  const RepairResult result = repair_design(design, [&](const std::string& what, double) {
    return what.find("weak points") == std::string::npos || ++calls < 2;
  });
  EXPECT_EQ(result.solve.status, SolveStatus::stopped);
  ASSERT_GE(result.steps.size(), 2u);
  expect_constraints_kept(result.design);
}

TEST(Repair, StartsFromASolutionThatIsKnownAsFromItsOwn) {
  const Design design = with_weak_contacts();
  const VerificationReport report = verify_design(design, {});
  ASSERT_TRUE(report.solved);
  const RepairResult own = repair_design(design, {});
  const RepairResult given = repair_design(design, {}, {}, most_repair_steps, report.solved);
  EXPECT_GT(own.largest_move, 0);
  EXPECT_EQ(own.design.T, given.design.T);
  EXPECT_EQ(own.design.q, given.design.q);
}

TEST(Repair, OneThreadOrTwoGiveTheSameBits) {
  const Design design = with_weak_contacts();
  const int threads = thread_count();
  set_thread_count(1);
  const RepairResult a = repair_design(design, {});
  set_thread_count(2);
  const RepairResult b = repair_design(design, {});
  set_thread_count(threads);
  EXPECT_GT(a.largest_move, 0);
  EXPECT_EQ(a.design.T, b.design.T);
  EXPECT_EQ(a.design.q, b.design.q);
}

TEST(Repair, LetsADesignNeedLittleFriction) {
  Design design = dome_design();
  design.parameters.self_shaping = true;
  const auto needed = [](const Design& d) {
    const DesignGeometry geometry = make_geometry(d.mesh, d.cuts, d.parameters);
    return find_friction_needed(solve_design(geometry, d, {}), geometry, {}).coefficient.value();
  };
  const RepairResult result = repair_design(design, {});
  ASSERT_TRUE(result.solve.converged());
  ASSERT_TRUE(result.verification && result.verification->valid);
  expect_constraints_kept(result.design);
  EXPECT_EQ(result.design.mesh.V, design.mesh.V);
  EXPECT_LT(needed(result.design), 0.8 * needed(design));
}

TEST(Repair, StoppedWhileFrictionFallsItKeepsTheValidDesign) {
  Design design = dome_design();
  design.parameters.self_shaping = true;
  const RepairResult result = repair_design(
      design, [](const std::string& what, double) { return what != "repair: friction needed"; });
  EXPECT_EQ(result.solve.status, SolveStatus::stopped);
  ASSERT_TRUE(result.verification && result.verification->valid);
  EXPECT_EQ(result.design.T, design.T);
}

}  // namespace
}  // namespace curveups
