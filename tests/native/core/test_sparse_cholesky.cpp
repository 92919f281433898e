// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/core/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

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

}  // namespace
}  // namespace curveups
