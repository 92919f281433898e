// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "curveups/physics/contact_forces.hpp"
#include "curveups/physics/unilateral.hpp"

namespace curveups {
namespace {

// Tiles in a row along x at distance 10, neighbours touching in a square of side 2 in between.
std::vector<ContactPoint> row_of_tiles(int tiles) {
  std::vector<ContactPoint> points;
  for (int i = 0; i + 1 < tiles; ++i) {
    for (const auto& [y, z] : {std::pair(-1., -1.), {1., -1.}, {1., 1.}, {-1., 1.}}) {
      points.push_back({Vec3(10 * i + 5, y, z), Vec3::UnitX(), {i, i + 1}, i});
    }
  }
  return points;
}

Points3 row_centres(int tiles) {
  Points3 centres = Points3::Zero(tiles, 3);
  for (int i = 0; i < tiles; ++i) centres(i, 0) = 10 * i;
  return centres;
}

// Equal and opposite wrenches on the two ends, given at the interface between tiles 0 and 1.
Wrenches on_two(const Vec3& force, const Vec3& torque) {
  Wrenches w = Wrenches::Zero(2, 6);
  const Vec3 arm0(5, 0, 0), arm1(-5, 0, 0);
  w.row(0) << force.transpose(), (torque + arm0.cross(force)).transpose();
  w.row(1) << -force.transpose(), (-torque - arm1.cross(force)).transpose();
  return w;
}

UnilateralResult unilateral(const Wrenches& loads, double mu, double scale = 1) {
  BalanceSystem system(row_of_tiles(2), row_centres(2), 7, {});
  const ContactForces start = solve_contact_forces(system, loads);
  UnilateralOptions options;
  options.friction_coefficient = mu;
  options.scale = scale;
  return solve_unilateral(system, loads, start.force, options);
}

TEST(ContactForces, LeastSquaresIsTheSmallestBalancedForce) {
  const Wrenches loads = on_two({8, 0, 0}, {0, 0, 0});
  BalanceSystem system(row_of_tiles(2), row_centres(2), 7, {});
  const ContactForces f = solve_contact_forces(system, loads);
  EXPECT_EQ(system.rows(), 6);
  for (int p = 0; p < 4; ++p) {
    EXPECT_NEAR(f.force(p, 0), 2, 1e-12);  // pushed together: positive
    EXPECT_NEAR(f.force.row(p).tail<2>().norm(), 0, 1e-12);
  }
  EXPECT_LT(f.imbalance, 1e-12);
  // Against the pseudo-inverse of the whole system, for a random wrench.
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Wrenches random = on_two({uniform(generator), uniform(generator), uniform(generator)},
                                 {uniform(generator), uniform(generator), uniform(generator)});
  const ContactForces g = solve_contact_forces(system, random);
  Eigen::MatrixXd A(6, 12);
  for (int c = 0; c < 12; ++c) A.col(c) = system.apply(Eigen::VectorXd::Unit(12, c));
  const Eigen::VectorXd expected =
      -A.completeOrthogonalDecomposition().solve(system.restrict(random));
  for (int p = 0; p < 4; ++p)
    EXPECT_LT((g.force.row(p).transpose() - expected.segment<3>(3 * p)).norm(), 1e-12);
}

TEST(ContactForces, BalancesEveryTileOfAChainAndOfSeveralComponents) {
  // Tiles 0-1-2, 4-5 in contact, 3 alone.
  std::vector<ContactPoint> points;
  for (const ContactPoint& p : row_of_tiles(6)) {
    if (p.contact != 2 && p.contact != 3) points.push_back(p);
  }
  const Points3 centres = row_centres(6);
  BalanceSystem system(points, centres, 7, {});
  EXPECT_EQ(system.rows(), 18);
  EXPECT_FALSE(system.has_rows(3));
  Wrenches loads = Wrenches::Zero(6, 6);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd f(3 * points.size());
  for (int i = 0; i < f.size(); ++i) f(i) = uniform(generator);
  loads = -system.wrenches(f);
  const ContactForces solved = solve_contact_forces(system, loads);
  const Eigen::VectorXd g =
      Eigen::Map<const Eigen::VectorXd>(solved.force.data(), solved.force.size());
  EXPECT_LT((loads + system.wrenches(g)).cwiseAbs().maxCoeff(),
            1e-11);  // all tiles, dropped ones too
  EXPECT_LE(g.norm(), f.norm() + 1e-12);
  EXPECT_TRUE(solved.unbalanced_tiles.empty());
}

TEST(ContactForces, AHingeThatCannotHoldItsTileIsNamed) {
  std::vector<ContactPoint> points = row_of_tiles(2);
  points.resize(2);  // both on the line z = -1: a torque about it can't be held
  BalanceSystem system(points, row_centres(2), 7, {});
  const ContactForces held = solve_contact_forces(
      system, on_two({1, 0, 0}, Vec3(0, 0, 0.3) + Vec3(0, 0, -1).cross(Vec3(1, 0, 0))));
  EXPECT_LT(held.imbalance, 1e-6);
  const ContactForces open = solve_contact_forces(system, on_two({1, 0, 0}, {0, 1.5, 0}));
  EXPECT_GT(open.imbalance, 1e-3);
  EXPECT_EQ(open.unbalanced_tiles, std::vector<int>{1});
}

TEST(ContactForces, HeldTilesCarryWhatIsLeft) {
  BalanceSystem system(row_of_tiles(3), row_centres(3), 7, {0});
  EXPECT_EQ(system.rows(), 12);
  Wrenches loads = Wrenches::Zero(3, 6);
  loads(2, 2) = -1;  // the last tile's weight
  const ContactForces f = solve_contact_forces(system, loads);
  const Wrenches total =
      loads + system.wrenches(Eigen::Map<const Eigen::VectorXd>(f.force.data(), f.force.size()));
  EXPECT_LT(total.bottomRows(2).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(total(0, 2), -1, 1e-12);
  EXPECT_NEAR(total(0, 4), 20, 1e-11);  // 1 N at 20 mm
}

TEST(Unilateral, FindsTheLargestFloorInClosedForm) {
  // 8 N through the middle: 2 N a point. Through y = 0.5: the lighter pair shares 8 (1 - 0.5) / 2.
  for (double mu : {0.5, 5.0}) {
    const UnilateralResult centred = unilateral(on_two({8, 0, 0}, {0, 0, 0}), mu, 10);
    ASSERT_EQ(centred.solve.status, SolveStatus::converged);
    EXPECT_NEAR(centred.largest_floor, 2, 1e-4);
    const UnilateralResult off =
        unilateral(on_two({8, 0, 0}, Vec3(0, 0.5, 0).cross(Vec3(8, 0, 0))), mu, 10);
    ASSERT_EQ(off.solve.status, SolveStatus::converged);
    EXPECT_NEAR(off.largest_floor, 1, 1e-4);
    EXPECT_NEAR(unilateral(on_two({8, 0, 0}, {0, 0, 0}), mu, 0.5).largest_floor, 0.5,
                1e-5);  // the cap
  }
}

TEST(Unilateral, SaysInfeasibleWhereItIs) {
  // Pulled apart.
  for (double mu : {0.5, 5.0}) {
    const UnilateralResult apart = unilateral(on_two({-4, 0, 0}, {0, 0, 0}), mu);
    EXPECT_EQ(apart.solve.status, SolveStatus::infeasible);
    EXPECT_NEAR(apart.largest_floor, -1, 1e-3);
  }
  // Tipped over the edge of the only contact: the line of action passes at y = 1.2.
  const Wrenches tipped = on_two({8, 0, 0}, Vec3(0, 1.2, 0).cross(Vec3(8, 0, 0)));
  EXPECT_EQ(unilateral(tipped, 5).solve.status, SolveStatus::infeasible);
  EXPECT_LT(unilateral(tipped, 0.5).largest_floor, -1e-3);
  EXPECT_EQ(unilateral(on_two({8, 0, 0}, Vec3(0, 0.99, 0).cross(Vec3(8, 0, 0))), 0.5).solve.status,
            SolveStatus::converged);
}

TEST(Unilateral, FollowsTheFrictionCone) {
  // 8 N of pressure and 4 N of shear need mu = 0.5 exactly, whatever the direction of the shear.
  for (double angle : {0.0, 0.3, 0.7854, 1.2}) {
    const Vec3 shear(0, 4 * std::cos(angle), 4 * std::sin(angle));
    const Wrenches loads = on_two(Vec3(8, 0, 0) + shear, {0, 0, 0});
    EXPECT_EQ(unilateral(loads, 0.502).solve.status, SolveStatus::converged) << angle;
    EXPECT_EQ(unilateral(loads, 0.498).solve.status, SolveStatus::infeasible) << angle;
  }
}

TEST(Unilateral, ForcesBalanceAndKeepTheirCones) {
  const Wrenches loads = on_two({8, 1, -2}, {1, 0.5, -0.7});
  BalanceSystem system(row_of_tiles(2), row_centres(2), 7, {});
  const ContactForces start = solve_contact_forces(system, loads);
  UnilateralOptions options;
  options.scale = 2;
  const UnilateralResult r = solve_unilateral(system, loads, start.force, options);
  ASSERT_EQ(r.solve.status, SolveStatus::converged);
  const Eigen::VectorXd f = Eigen::Map<const Eigen::VectorXd>(r.force.data(), r.force.size());
  EXPECT_LT((system.apply(f) + system.restrict(loads)).norm(), 1e-6);
  for (int p = 0; p < 4; ++p) {
    EXPECT_GE(r.force(p, 0), r.largest_floor - 1e-9);
    EXPECT_LE(r.force.row(p).tail<2>().norm(), 0.5 * r.force(p, 0) + 1e-5);
  }
}

TEST(Unilateral, ATileWithoutContactsIsFeasibleOnlyUnloaded) {
  BalanceSystem free({}, row_centres(1), 7, {});
  EXPECT_EQ(solve_unilateral(free, Wrenches::Zero(1, 6), Points3(0, 3), {}).solve.status,
            SolveStatus::converged);
}

}  // namespace
}  // namespace curveups
