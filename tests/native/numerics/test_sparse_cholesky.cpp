// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <thread>
#include <vector>

#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

// Lower triangle of a Laplacian on an n x n grid plus shift.
SparseMatrix grid(int n, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  auto id = [n](int r, int c) { return r * n + c; };
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c < n; ++c) {
      entries.emplace_back(id(r, c), id(r, c), 4 + shift);
      if (c + 1 < n) entries.emplace_back(id(r, c + 1), id(r, c), -1);
      if (r + 1 < n) entries.emplace_back(id(r + 1, c), id(r, c), -1);
    }
  }
  SparseMatrix a(n * n, n * n);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

TEST(SparseCholesky, SolvesWithSeveralRightHandSidesAndNewValues) {
  SparseCholesky cholesky;
  for (double shift : {0.1, 2.0}) {
    const SparseMatrix a = grid(30, shift);
    ASSERT_TRUE(cholesky.factorize(a));
    const Eigen::MatrixXd x = Eigen::MatrixXd::Random(900, 3);
    const Eigen::MatrixXd b = a.selfadjointView<Eigen::Lower>() * x;
    EXPECT_LT((cholesky.solve(b) - x).norm(), 1e-10 * x.norm());
  }
}

TEST(SparseCholesky, SaysWhatIsNotPositiveDefinite) {
  SparseCholesky cholesky;
  EXPECT_FALSE(cholesky.factorize(grid(10, -3)));
  SparseMatrix a = grid(10, 0);
  a.valuePtr()[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(cholesky.factorize(a));
  EXPECT_TRUE(cholesky.factorize(grid(10, 0)));  // and goes on to work
}

TEST(SparseCholesky, TwoAtOnceGiveTheSameBits) {
  const SparseMatrix a = grid(60, 0.01);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(3600, -1, 1);
  auto solve = [&] {
    SparseCholesky cholesky;
    EXPECT_TRUE(cholesky.factorize(a));
    return Eigen::VectorXd(cholesky.solve(b));
  };
  const Eigen::VectorXd alone = solve();
  Eigen::VectorXd first, second;
  std::thread other([&] { first = solve(); });
  second = solve();
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TEST(SparseCholesky, AnEliminationOrderIsOneWithLittleFill) {
  EXPECT_TRUE(elimination_order({}).empty());
  // A star: its centre, numbered first, would fill everything, so that it goes among the last two.
  std::vector<std::vector<int>> star(50);
  for (int v = 1; v < 50; ++v) star[0].push_back(v);
  std::vector<int> order = elimination_order(star);
  ASSERT_EQ(order.size(), 50u);
  EXPECT_TRUE(order[49] == 0 || order[48] == 0);
  std::sort(order.begin(), order.end());
  for (int k = 0; k < 50; ++k) EXPECT_EQ(order[k], k);
}

TEST(SparseCholesky, SolvesInTheOrderGiven) {
  const SparseMatrix a = grid(30, 0.1);
  std::vector<std::vector<int>> above(a.rows());
  for (int c = 0; c < a.cols(); ++c) {
    for (SparseMatrix::InnerIterator it(a, c); it; ++it) {
      if (it.row() > c) above[c].push_back(static_cast<int>(it.row()));
    }
  }
  const std::vector<int> order = elimination_order(above);
  Eigen::PermutationMatrix<Eigen::Dynamic> P(a.rows());
  for (int k = 0; k < a.rows(); ++k) P.indices()(order[k]) = k;
  SparseMatrix permuted(a.rows(), a.cols());
  permuted.selfadjointView<Eigen::Lower>() = a.selfadjointView<Eigen::Lower>().twistedBy(P);
  SparseCholesky cholesky(Ordering::as_given);
  ASSERT_TRUE(cholesky.factorize(permuted));
  for (int k = 0; k < a.rows(); ++k) EXPECT_EQ(cholesky.order()[k], k);
  const Eigen::VectorXd x = Eigen::VectorXd::Random(a.rows());
  const Eigen::VectorXd b = a.selfadjointView<Eigen::Lower>() * x;
  EXPECT_LT((P.transpose() * cholesky.solve(P * b) - x).norm(), 1e-10 * x.norm());
  // With L alone, x^T A x is the squared norm of half of the solution.
  const Eigen::VectorXd half = cholesky.solve_lower(P * b);
  EXPECT_NEAR(half.squaredNorm(), x.dot(b), 1e-10 * x.dot(b));
  EXPECT_LT((P.transpose() * cholesky.solve_upper(half) - x).norm(), 1e-10 * x.norm());
}

}  // namespace
}  // namespace curveups
