// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "curveups/numerics/least_step.hpp"

namespace curveups {
namespace {

LeastStepProblem make_problem(int unknowns, double reach) {
  LeastStepProblem p;
  p.sparse.resize(0, unknowns);
  p.sparse_value.resize(0);
  p.dense.resize(unknowns, 0);
  p.dense_value.resize(0);
  p.lower = Eigen::VectorXd::Constant(unknowns, -reach);
  p.upper = Eigen::VectorXd::Constant(unknowns, reach);
  return p;
}

TEST(LeastStep, IsZeroWhereNothingIsAsked) {
  LeastStepProblem p = make_problem(3, 1);
  p.sparse.resize(1, 3);
  p.sparse.insert(0, 1) = 1;
  p.sparse_value = Eigen::VectorXd::Constant(1, 0.5);
  const LeastStep step = solve_least_step(p);
  EXPECT_TRUE(step.solve.converged());
  EXPECT_LT(step.z.norm(), 1e-6);
}

TEST(LeastStep, FollowsOneRowAlongItsNormal) {
  LeastStepProblem p = make_problem(4, 10);
  p.dense = Eigen::Vector4d(1, 2, -2, 4);
  p.dense_value = Eigen::VectorXd::Constant(1, -5);
  const LeastStep step = solve_least_step(p);
  EXPECT_TRUE(step.solve.converged());
  const Eigen::Vector4d expected = p.dense.col(0) * 5 / 25;
  EXPECT_LT((step.z - expected).norm(), 1e-7);
  EXPECT_NEAR(step.dense_multiplier(0), 0.2, 1e-6);
}

TEST(LeastStep, SharesTheLoadWhereAnUnknownIsAtItsBound) {
  LeastStepProblem p = make_problem(2, 10);
  p.upper(0) = 0.5;
  p.dense = Eigen::Vector2d(1, 1);
  p.dense_value = Eigen::VectorXd::Constant(1, -3);
  const LeastStep step = solve_least_step(p);
  EXPECT_TRUE(step.solve.converged());
  EXPECT_NEAR(step.z(0), 0.5, 1e-9);
  EXPECT_NEAR(step.z(1), 2.5, 1e-9);
  EXPECT_NEAR(step.upper_multiplier(0), 2.0, 1e-5);
}

TEST(LeastStep, SaysByTheMultiplierWhatCannotBeMet) {
  // z1 >= 3 is asked of a box of 1: the row stays at its penalty; the row of the larger one, z2 <=
  // z1 - 1 holds.
  LeastStepProblem p = make_problem(2, 1);
  p.sparse.resize(1, 2);
  p.sparse.insert(0, 0) = 1;
  p.sparse.insert(0, 1) = -1;
  p.sparse_value = Eigen::VectorXd::Constant(1, -1);
  p.dense = Eigen::Vector2d(1, 1);
  p.dense_value = Eigen::VectorXd::Constant(1, -3);
  const LeastStep step = solve_least_step(p);
  EXPECT_TRUE(step.solve.converged());
  EXPECT_NEAR(step.z(0), 1, 1e-6);
  EXPECT_NEAR(step.z(1), 0, 1e-6);
  EXPECT_NEAR(step.dense_multiplier(0), p.dense_penalty, 1e-3);
}

// Rows of random entries; the dense ones lack `wanting`.
LeastStepProblem make_random_problem(int seed, int n, int rows, int dense, double bound,
                                     double wanting) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  LeastStepProblem p = make_problem(n, bound);
  p.sparse.resize(rows, n);
  p.sparse_value.resize(rows);
  p.dense.resize(n, dense);
  p.dense_value.setConstant(dense, -wanting);
  for (int r = 0; r < rows; ++r) {
    for (int k = 0; k < 5; ++k) p.sparse.coeffRef(r, (7 * r + 11 * k) % n) = uniform(generator);
    p.sparse_value(r) = 0.1 * uniform(generator) + 0.05;
  }
  for (int k = 0; k < dense; ++k) {
    for (int i = 0; i < n; ++i) p.dense(i, k) = uniform(generator);
  }
  return p;
}

void expect_stationary(const LeastStepProblem& p, const LeastStep& step) {
  const Eigen::VectorXd rest = step.z - p.sparse.transpose() * step.sparse_multiplier -
                               p.dense * step.dense_multiplier - step.lower_multiplier +
                               step.upper_multiplier;
  EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-6);
}

TEST(LeastStep, MeetsTheOptimalityConditionsOfRandomProblems) {
  for (int round = 0; round < 8; ++round) {
    const LeastStepProblem p = make_random_problem(round, 60, 90, 6, 0.3, 0.2);
    const LeastStep step = solve_least_step(p);
    ASSERT_TRUE(step.solve.converged()) << round;
    const Eigen::VectorXd c = p.sparse * step.z + p.sparse_value,
                          d = p.dense.transpose() * step.z + p.dense_value;
    for (Eigen::Index r = 0; r < c.size(); ++r) {
      EXPECT_GE(c(r), -1e-7);
      EXPECT_LT(step.sparse_multiplier(r) * c(r), 1e-6);
    }
    EXPECT_GE(d.minCoeff(), -1e-7);
    expect_stationary(p, step);
    EXPECT_LE(step.z.cwiseAbs().maxCoeff(), 0.3);
  }
}

// Multipliers of soft rows are up to the penalty; rounding of the dense rows must not outgrow the
// rest.
TEST(LeastStep, KeepsItsDigitsWhereManyDenseRowsStayUnmet) {
  const LeastStepProblem p = make_random_problem(8, 400, 300, 80, 0.2, 5);
  const LeastStep step = solve_least_step(p);
  EXPECT_TRUE(step.solve.converged());
  EXPECT_LT(step.solve.iterations, 40);
  expect_stationary(p, step);
  const Eigen::VectorXd d = p.dense.transpose() * step.z + p.dense_value;
  EXPECT_LT(d.minCoeff(), -1);
  for (Eigen::Index k = 0; k < d.size(); ++k) {
    const double m = step.dense_multiplier(k);
    EXPECT_NEAR(d(k) < -1e-6 ? p.dense_penalty - m : d(k) * m, 0, 1e-3);
  }
}

}  // namespace
}  // namespace curveups
