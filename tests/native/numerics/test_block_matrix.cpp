// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cstdlib>

#include "curveups/numerics/block_matrix.hpp"

namespace curveups {
namespace {

// A ring of blocks with chords, one block held; elements of two blocks add v v^T. Every third block
// has `narrow` unknowns.
template <int W>
void expect_dense_solution(int narrow = W) {
  const int count = 12, held = 5;
  std::vector<int> unknowns(count, W);
  for (int b = 0; b < count; b += 3) unknowns[b] = narrow;
  std::srand(4);
  std::vector<char> free(count, 1);
  free[held] = 0;
  std::vector<Coupling> couplings;
  for (int b = 0; b < count; ++b) {
    couplings.push_back({b, (b + 1) % count});
    couplings.push_back({(b + 5) % count, b});
  }
  couplings.push_back({-1, 3});
  couplings.push_back(couplings[0]);  // once more
  BlockMatrix<W> matrix(std::make_shared<const BlockPattern>(free, couplings), unknowns);
  const BlockPattern& pattern = matrix.pattern();
  EXPECT_EQ(pattern.block_count(), count);
  EXPECT_EQ(pattern.free_count(), count - 1);
  EXPECT_FALSE(pattern.slot(2 * count).stored());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(W * count, W * count);
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const auto [i, j] = couplings[k];
    if (i < 0 || i == held || j == held) continue;
    Eigen::VectorXd v = Eigen::VectorXd::Zero(W * count), known = v;
    v.segment<W>(W * i).setRandom();
    v.segment<W>(W * j).setRandom();
    for (int block : {i, j}) {
      known.segment(W * block, unknowns[block]) = v.segment(W * block, unknowns[block]);
    }
    dense += known * known.transpose();
    auto outer = [&](int a, int b) -> typename BlockMatrix<W>::Block {
      return v.segment<W>(W * a) * v.segment<W>(W * b).transpose();
    };
    matrix.add(pattern.diagonal(i), outer(i, i));
    matrix.add(pattern.diagonal(j), outer(j, j));
    const BlockSlot& slot = pattern.slot(static_cast<int>(k));
    matrix.add(slot, slot.swapped ? outer(j, i) : outer(i, j));
  }
  Eigen::MatrixXd b = Eigen::MatrixXd::Random(W * count, 3);
  b.middleRows<W>(W * held).setZero();
  for (int k = 0; k < count; ++k) b.middleRows(W * k, W).bottomRows(W - unknowns[k]).setZero();
  EXPECT_LT((matrix.multiply(b) - dense * b).norm(), 1e-12 * b.norm() * dense.norm());
  for (double damping : {0.0, 0.3}) {
    Eigen::MatrixXd damped = dense;
    damped.diagonal() = damped.diagonal() * (1 + damping);
    damped.diagonal().array() += 2;
    ASSERT_TRUE(matrix.factorize(damping, 2));
    EXPECT_LT((matrix.solve(b) - damped.llt().solve(b)).norm(), 1e-10 * b.norm());
  }
  EXPECT_LT((matrix.multiply(b) - dense * b).norm(), 1e-12 * b.norm() * dense.norm());
  EXPECT_FALSE(matrix.factorize(0, -100));
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < unknowns[k] && k != held; ++c) matrix.diagonal(k, c) += 2;
  }
  dense.diagonal().array() += 2;
  for (double tolerance : {0.1, 1e-10}) {
    const Eigen::VectorXd x = matrix.solve_iteratively(b.col(0), tolerance);
    EXPECT_LE((dense * x - b.col(0)).norm(), 1.001 * tolerance * b.col(0).norm());
  }
  matrix.set_zero();
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < unknowns[k] && k != held; ++c) matrix.diagonal(k, c) = k % 2 ? 1 : -1;
  }
  EXPECT_GT(matrix.solve_iteratively(b.col(0), 1e-10).dot(b.col(0)), 0);  // a descent direction
}

TEST(BlockMatrix, IsTheSumOfItsElementsInTheCallersNumbering) {
  expect_dense_solution<1>();
  expect_dense_solution<3>();
  expect_dense_solution<6>();
  expect_dense_solution<9>();
}

TEST(BlockMatrix, HasNoRowsForWhatABlockHasNot) {
  expect_dense_solution<6>(3);
  expect_dense_solution<6>(1);
}

}  // namespace
}  // namespace curveups
