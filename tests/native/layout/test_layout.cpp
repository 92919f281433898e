// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/core/tolerances.hpp"
#include "curveups/layout/arrange.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout.hpp"
#include "curveups/layout/layout_terms.hpp"
#include "support/meshes.hpp"

namespace curveups {
namespace {

const Edges no_cuts(0, 2);

void expect_sound(const DesignGeometry& geometry, const FlatPoses& poses, const Array6& q,
                  const Parameters& p) {
  const ConstraintReport report =
      check_constraints(geometry, flat_corners(geometry.tiles, poses), q, p);
  EXPECT_LE(report.max_gap_violation_mm, tolerance::constraint);
  EXPECT_LE(report.max_pin_bound_violation_mm, tolerance::constraint);
  EXPECT_LE(report.max_pin_area_violation_mm2, tolerance::constraint);
  EXPECT_LE(report.max_rigidity_mm, 1e-9);
  EXPECT_TRUE(report.close_pairs.empty());
}

TEST(Layout, KeepsEveryHardConstraint) {
  const Parameters p;
  for (const TriangleMesh& mesh :
       {test::dome(8), test::dome(4), test::saddle(8), test::ripples(8), test::flat_patch(5),
        test::single_triangle(), test::hinge(0.4)}) {
    const DesignGeometry geometry = make_geometry(mesh, no_cuts, p);
    const LayoutResult result = solve_layout(geometry, p, {});
    EXPECT_TRUE(result.solve.converged());
    expect_sound(geometry, result.poses, result.q, p);
  }
}

TEST(Layout, FlatTargetIsPackedAtExactlyTheGap) {
  Parameters p;
  const DesignGeometry geometry = make_geometry(test::flat_patch(5), no_cuts, p);
  const LayoutResult result = solve_layout(geometry, p, {});
  // All tiles spread evenly is feasible with every gap at its least: packing can't do better.
  const double inradius = 7 * std::sqrt(0.75) / 3;
  const double factor = 1 + p.d_gap_min / (2 * inradius);
  double expected = 0;
  const double gap = (factor - 1) * 2 * inradius;
  for (std::size_t k = 0; k < geometry.tiles.contacts.size(); ++k) {
    expected += 2 * std::pow(gap / 7, 4);
  }
  EXPECT_GE(result.energies.at("packing"), w_p * expected);
  EXPECT_NEAR(result.energies.at("packing"), w_p * expected, 2e-3 * w_p * expected);
  EXPECT_LT(result.energies.at("alignment"), 1e-3);
}

TEST(Layout, IsTheSameWhateverWayTheTargetLies) {
  const Parameters p;
  TriangleMesh mesh = test::dome(6);
  const LayoutResult a = solve_layout(make_geometry(mesh, no_cuts, p), p, {});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  mesh.V = (mesh.V * turn.transpose()).eval();
  const LayoutResult b = solve_layout(make_geometry(mesh, no_cuts, p), p, {});
  double sum_a = 0, sum_b = 0;
  for (const auto& [name, value] : a.energies) sum_a += value;
  for (const auto& [name, value] : b.energies) sum_b += value;
  EXPECT_NEAR(sum_a, sum_b, 1e-4 * sum_a);
}

TEST(Layout, PiecesOfACutLieSideBySide) {
  const Parameters p;
  const TriangleMesh mesh = test::dome(6);
  // A row of vertices across the patch.
  Edges cuts(6, 2);
  for (int c = 0; c < 6; ++c) cuts.row(c) << 3 * 7 + c, 3 * 7 + c + 1;
  const DesignGeometry geometry = make_geometry(mesh, cuts, p);
  const auto pieces = pieces_of(geometry.tiles);
  ASSERT_EQ(pieces.size(), 2u);
  const LayoutResult result = solve_layout(geometry, p, {});
  EXPECT_TRUE(result.solve.converged());
  expect_sound(geometry, result.poses, result.q, p);
  for (int i : pieces[0]) {
    for (int j : pieces[1]) {
      EXPECT_GT((result.poses.row(i) - result.poses.row(j)).head<2>().norm(), 15);
    }
  }
}

TEST(Layout, LipsOfASlitKeepTheGap) {
  const Parameters p;
  Edges cuts(3, 2);
  for (int c = 0; c < 3; ++c) cuts.row(c) << 3 * 7 + c, 3 * 7 + c + 1;
  const DesignGeometry geometry = make_geometry(test::dome(6), cuts, p);
  ASSERT_EQ(pieces_of(geometry.tiles).size(), 1u);
  const LayoutResult result = solve_layout(geometry, p, {});
  EXPECT_TRUE(result.solve.converged());
  expect_sound(geometry, result.poses, result.q, p);
}

TEST(Layout, ProgressNeverGoesBack) {
  const Parameters p;
  const DesignGeometry geometry = make_geometry(test::ripples(6), no_cuts, p);
  double last = 0;
  solve_layout(geometry, p, [&](const std::string&, double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    return true;
  });
  EXPECT_GT(last, 0.8);
}

TEST(Arrange, TurnsAPieceToItsSmallestRectangle) {
  const Parameters p;
  const DesignGeometry geometry = make_geometry(test::flat_patch(6), no_cuts, p);
  const LayoutResult result = solve_layout(geometry, p, {});
  auto extent = [&](double angle) {
    const PlaneRotation turn(angle);
    Vec2 low = Vec2::Constant(1e9), high = -low;
    for (int i = 0; i < geometry.tiles.tile_count(); ++i) {
      for (const Vec2& q : place(result.poses, i, geometry.tiles.front[i])) {
        low = low.cwiseMin(turn * q);
        high = high.cwiseMax(turn * q);
      }
    }
    return Vec2(high - low);
  };
  const double area = extent(0).prod();
  EXPECT_GE(extent(0).x(), extent(0).y());
  for (double angle = 0.05; angle < 3.1; angle += 0.05)
    EXPECT_GE(extent(angle).prod(), area * (1 - 1e-6));
}

TEST(Layout, EveryIterateIsHandedOut) {
  const Parameters p;
  const DesignGeometry geometry = make_geometry(test::dome(6), no_cuts, p);
  std::vector<double> energies, violations;
  const LayoutResult result =
      solve_layout(geometry, p, {}, LayoutEffort::full,
                   [&](const FlatPoses& poses, const Array6& q, double energy, double violation) {
                     EXPECT_TRUE(poses.allFinite() && q.allFinite());
                     energies.push_back(energy);
                     violations.push_back(violation);
                     return true;
                   });
  EXPECT_TRUE(result.solve.converged());
  ASSERT_GE(static_cast<int>(energies.size()), result.solve.iterations);
  double sum = 0;
  for (const auto& [name, value] : result.energies) sum += value;
  EXPECT_NEAR(energies.back(), sum, 1e-3 * sum);
  EXPECT_GT(violations.front(), 0.1);
  EXPECT_LT(violations.back(), 1e-3);

  int calls = 0;
  const LayoutResult stopped =
      solve_layout(geometry, p, {}, LayoutEffort::full,
                   [&](const FlatPoses&, const Array6&, double, double) { return ++calls < 3; });
  EXPECT_TRUE(stopped.solve.stopped());
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace curveups
