// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/numerics/cone_program.hpp"

namespace curveups {
namespace {

class DenseMap : public ForceMap {
 public:
  explicit DenseMap(Eigen::MatrixXd A) : A_(std::move(A)) {}

  int point_count() const override { return static_cast<int>(A_.cols()) / 3; }
  int rows() const override { return static_cast<int>(A_.rows()); }
  Eigen::VectorXd apply(const Eigen::VectorXd& f) const override { return A_ * f; }
  Eigen::VectorXd apply_transposed(const Eigen::VectorXd& y) const override {
    return A_.transpose() * y;
  }
  bool factorize(const std::vector<Eigen::Matrix3d>& D) override {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(rows(), rows());
    for (int p = 0; p < point_count(); ++p) {
      normal += A_.middleCols<3>(3 * p) * D[p] * A_.middleCols<3>(3 * p).transpose();
    }
    factor_.compute(normal);
    return factor_.info() == Eigen::Success;
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const override {
    return factor_.solve(right);
  }

 private:
  Eigen::MatrixXd A_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

// A body on points in a plane: their forces add up.
DenseMap body_on(int points) {
  Eigen::MatrixXd A(3, 3 * points);
  for (int p = 0; p < points; ++p) A.middleCols<3>(3 * p).setIdentity();
  return DenseMap(A);
}

ConeSolution solve(DenseMap& map, const Eigen::VectorXd& b, const ConeOptions& options) {
  return solve_cone_program(map, b, Eigen::VectorXd::Zero(3 * map.point_count()), options, {});
}

// Weight of a body on a slope, by the normal and the tangents.
Vec3 on_slope(double weight, double angle) {
  return weight * Vec3(-std::cos(angle), std::sin(angle), 0);
}

void expect_feasible(const DenseMap& map, const Eigen::VectorXd& b, const ConeSolution& solution,
                     double mu, double tolerance) {
  EXPECT_LT((map.apply(solution.force) + b).cwiseAbs().maxCoeff(), 1e-9);
  for (int p = 0; p < map.point_count(); ++p) {
    const Vec3 f = solution.force.segment<3>(3 * p);
    EXPECT_GE(f.x(), solution.s - tolerance);
    EXPECT_LE(f.tail<2>().norm(), mu * f.x() + tolerance);
  }
}

TEST(ConeProgram, SharesAWeightEvenly) {
  DenseMap map = body_on(4);
  const Vec3 b = on_slope(2, 0);
  const ConeSolution solution = solve(map, b, {0.5, false, 1e-8});
  ASSERT_TRUE(solution.solve.converged());
  EXPECT_NEAR(solution.s, 0.5, 1e-7);
  expect_feasible(map, b, solution, 0.5, 1e-7);
  // A floor beyond 1 is not asked for.
  EXPECT_NEAR(solve(map, on_slope(20, 0), {0.5, false, 1e-8}).s, 1, 1e-7);
}

TEST(ConeProgram, SaysHowMuchFrictionIsToSpareOrLacking) {
  DenseMap map = body_on(4);
  for (double angle : {0.1, 0.6}) {
    ConeOptions options{0.3, false, 1e-8};
    options.friction = true;
    options.floor = 0.2;
    const Vec3 b = on_slope(2, angle);
    const ConeSolution solution = solve(map, b, options);
    ASSERT_TRUE(solution.solve.converged());
    // Shared evenly: |t| <= mu n - s.
    EXPECT_NEAR(solution.s, 0.5 * (0.3 * std::cos(angle) - std::sin(angle)), 1e-7);
    EXPECT_LT((map.apply(solution.force) + b).cwiseAbs().maxCoeff(), 1e-9);
    for (int p = 0; p < 4; ++p) {
      EXPECT_GE(solution.force(3 * p), 0.2 - 1e-7);
      EXPECT_LE(solution.force.segment<2>(3 * p + 1).norm(),
                0.3 * solution.force(3 * p) - solution.s + 1e-7);
    }
    // Multipliers of the cones share out what s is worth.
    EXPECT_NEAR(solution.circle.col(0).sum(), 1, 1e-6);
  }
}

TEST(ConeProgram, ABodySlidesBeyondTheAngleOfFriction) {
  constexpr double mu = 0.3, tolerance = 1e-6;
  DenseMap map = body_on(3);
  const Vec3 gentle = on_slope(2, std::atan(0.99 * mu)), steep = on_slope(2, std::atan(1.5 * mu));
  const ConeSolution held = solve(map, gentle, {mu, false, tolerance});
  ASSERT_TRUE(held.solve.converged());
  EXPECT_NEAR(held.s, -gentle.x() / 3, 10 * tolerance);
  expect_feasible(map, gentle, held, mu, 10 * tolerance);
  EXPECT_FALSE(solve(map, steep, {mu, false, tolerance}).solve.converged());
  // Relaxed, |t| <= mu (n - s) says how much pull it lacks.
  const ConeSolution sliding = solve(map, steep, {mu, true, tolerance});
  ASSERT_TRUE(sliding.solve.converged());
  EXPECT_NEAR(sliding.s, (-steep.x() - steep.y() / mu) / 3, 10 * tolerance);
  EXPECT_LT(sliding.s, 0);
}

// The envelope theorem: the optimum follows b by -y.
TEST(ConeProgram, MultipliersAreDerivativesOfTheOptimum) {
  constexpr double mu = 0.3;
  DenseMap map = body_on(3);
  const ConeSolution held = solve(map, on_slope(2, std::atan(0.5 * mu)), {mu, false, 1e-6});
  ASSERT_TRUE(held.solve.converged());
  EXPECT_LT((held.y - Vec3(1.0 / 3, 0, 0)).norm(), 1e-2);
  const ConeSolution sliding = solve(map, on_slope(2, std::atan(1.5 * mu)), {mu, true, 1e-6});
  ASSERT_TRUE(sliding.solve.converged());
  EXPECT_LT((sliding.y - Vec3(1.0 / 3, 1 / (3 * mu), 0)).norm(), 1e-2);
}

TEST(ConeProgram, CanBeStopped) {
  DenseMap map = body_on(4);
  const Vec3 b = on_slope(2, 0);
  EXPECT_THROW(solve_cone_program(map, b, Eigen::VectorXd::Zero(12), {},
                                  [](const std::string&, double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace curveups
