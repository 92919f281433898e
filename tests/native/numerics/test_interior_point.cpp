// SPDX-License-Identifier: LGPL-2.1-or-later
// Problems whose solution is a projection: the nearest point of a polyhedron.
#include <gtest/gtest.h>

#include "curveups/numerics/interior_point.hpp"

namespace curveups {
namespace {

using Vector = BlockVector<9>;

// Half the squared distance from a point.
class Distance : public Residuals {
 public:
  explicit Distance(Vector goal) : goal_(std::move(goal)) {}
  std::string_view name() const override { return "distance"; }
  int element_count() const override { return static_cast<int>(goal_.rows()); }
  int dimension() const override { return 8; }
  Blocks blocks(int element) const override { return {element, -1}; }
  void evaluate(int element, const Unknowns& x, bool derivatives, Value& out) const override {
    for (int r = 0; r < 8; ++r) out.value(r) = x[0][r] - goal_(element, r);
    if (!derivatives) return;
    out.jacobian[0].setZero();
    for (int r = 0; r < 8; ++r) out.jacobian[0](r, r) = 1;
  }

 private:
  Vector goal_;
};

// x(block, unknown) of one block minus that of another at least `least`.
struct Apart {
  int block, other, unknown;
  double least;
};

class Distances : public Residuals {
 public:
  explicit Distances(const std::vector<Apart>& list) : list_(list) {}
  std::string_view name() const override { return "distances"; }
  int element_count() const override { return static_cast<int>(list_.size()); }
  int dimension() const override { return 1; }
  Blocks blocks(int e) const override { return {list_[e].block, list_[e].other}; }
  void evaluate(int e, const Unknowns& x, bool derivatives, Value& out) const override {
    const int u = list_[e].unknown;
    out.value(0) = x[0][u] - x[1][u] - list_[e].least;
    if (!derivatives) return;
    for (int k = 0; k < 2; ++k) {
      out.jacobian[k].row(0).setZero();
      out.jacobian[k](0, u) = k == 0 ? 1 : -1;
    }
  }

 private:
  const std::vector<Apart>& list_;
};

// Unknown 1 below a parabola of unknown 0. Steps follow its tangents, which lie above it, and don't
// know how it curves: the violation shrinks by a constant factor a step.
class Parabola : public Residuals {
 public:
  std::string_view name() const override { return "parabola"; }
  int element_count() const override { return 1; }
  int dimension() const override { return 1; }
  Blocks blocks(int) const override { return {0, -1}; }
  void evaluate(int, const Unknowns& x, bool derivatives, Value& out) const override {
    out.value(0) = -x[0][0] * x[0][0] - x[0][1];
    if (!derivatives) return;
    out.jacobian[0].row(0).setZero();
    out.jacobian[0](0, 0) = -2 * x[0][0];
    out.jacobian[0](0, 1) = -1;
  }
};

struct Problem {
  explicit Problem(int blocks) : goal(Vector::Zero(blocks, 9)) {}
  InteriorPoint method() {
    ResidualsList energies, constraints;
    energies.push_back(std::make_unique<Distance>(goal));
    constraints.push_back(std::make_unique<Distances>(apart));
    return {std::move(energies), std::move(constraints), bounds};
  }
  Vector goal;
  std::vector<Apart> apart;
  std::vector<Bound> bounds;
};

constexpr double mu_end = 1e-8;

TEST(InteriorPoint, FindsTheNearestPointWithConstraintsAndBounds) {
  Problem problem(3);
  problem.goal.row(1).setConstant(0.5);
  problem.apart = {{1, 0, 2, 2.5}, {2, 1, 2, 1}};  // the second one pushes the first two apart, too
  problem.bounds = {{0, 4, -1, 1}, {1, 4, 0.75, 2}, {2, 4, -3, -0.25}};
  auto method = problem.method();
  Vector z = Vector::Constant(3, 9, 7.0);  // not feasible
  const SolveReport report = method.run(z, {0.1, mu_end}, 100, "test", {});
  ASSERT_TRUE(report.converged());
  EXPECT_LE(report.residual, 1e-6);
  // Row 2 alone: least change of (0, 0.5, 0) with x1 - x0 = 2.5 and x2 - x1 = 1.
  EXPECT_NEAR(z(0, 2), (0 + 0.5 + 0) / 3.0 - 2.0, 1e-3);
  EXPECT_NEAR(z(1, 2), z(0, 2) + 2.5, 1e-5);
  EXPECT_NEAR(z(2, 2), z(1, 2) + 1, 1e-5);
  EXPECT_NEAR(z(0, 4), 0, 1e-3);
  EXPECT_NEAR(z(1, 4), 0.75, 1e-5);
  EXPECT_NEAR(z(2, 4), -0.25, 1e-5);
  EXPECT_NEAR(z(1, 7), 0.5, 1e-3);  // free
}

TEST(InteriorPoint, GoesOnWithWhatIsDiscoveredToTheSameSolution) {
  const std::vector<Apart> all = {{1, 0, 2, 2.5}, {2, 1, 2, 1}, {2, 0, 5, 0.3}};
  Problem known(3), discovering(3);
  known.apart = all;
  discovering.apart = {all[0]};
  Vector expected = Vector::Zero(3, 9), z = expected;
  ASSERT_TRUE(known.method().run(expected, {0.1, mu_end}, 100, "test", {}).converged());
  auto method = discovering.method();
  double last = 1;
  int solved = 0;
  const SolveReport report =
      method.run(z, {0.1, mu_end}, 100, "test", {}, [&](const Vector& at, double mu) {
        EXPECT_LE(mu, last);
        last = mu;
        ++solved;
        // The barrier problem is solved: what is known is kept.
        EXPECT_GT(at(1, 2) - at(0, 2), 2.5 - 10 * mu);
        // First while mu is large, then at the very end.
        const std::size_t due = mu <= mu_end ? 3 : solved >= 2 ? 2 : 1;
        if (discovering.apart.size() >= due) return false;
        discovering.apart.push_back(all[discovering.apart.size()]);
        return true;
      });
  ASSERT_TRUE(report.converged());
  EXPECT_EQ(last, mu_end);
  EXPECT_EQ(discovering.apart.size(), 3u);
  EXPECT_LE((z - expected).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LE(report.residual, 1e-6);
}

TEST(InteriorPoint, SaysThatItIsUnfinishedWhereNothingMeetsTheConstraints) {
  Problem problem(2);
  problem.apart = {{0, 1, 0, 1}, {1, 0, 0, 1}};
  Vector z = Vector::Zero(2, 9);
  const SolveReport report = problem.method().run(z, {0.1, mu_end}, 60, "test", {});
  EXPECT_FALSE(report.converged());
  EXPECT_GE(report.residual, 1 - 1e-6);
  EXPECT_TRUE(z.allFinite());
}

TEST(InteriorPoint, ViolatesNoConstraintByMoreThanItMay) {
  const auto largest_violation = [](const Levels& levels) {
    double largest = 0;
    for (int k = 0; k < 50; ++k) {
      Vector goal = Vector::Zero(1, 9), z = goal;
      goal(0, 0) = 0.01 * k;
      goal(0, 1) = 0.4;
      z(0, 0) = 1;
      ResidualsList energies, constraints;
      energies.push_back(std::make_unique<Distance>(goal));
      constraints.push_back(std::make_unique<Parabola>());
      InteriorPoint method(std::move(energies), std::move(constraints), {});
      const SolveReport report = method.run(z, levels, 100, "test", {});
      EXPECT_TRUE(report.converged()) << k;
      largest = std::max(largest, report.residual);
    }
    return largest;
  };
  // Complementarity alone lets violations of several times mu_end pass.
  EXPECT_GT(largest_violation({0.1, 1e-6}), 1e-6);
  EXPECT_LE(largest_violation({0.1, 1e-6, 1e-7}), 1e-7);
}

}  // namespace
}  // namespace curveups
