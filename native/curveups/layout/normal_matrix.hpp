// SPDX-License-Identifier: LGPL-2.1-or-later
// The sparse symmetric matrix sum of w J^T J over block functions: 9 x 9 blocks on the diagonal and
// for each pair of tiles that some block joins.
#pragma once

#include <vector>

#include "curveups/layout/block_function.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {

class NormalMatrix {
 public:
  // Pattern for the blocks of all these functions.
  NormalMatrix(int tile_count, const std::vector<const BlockFunction*>& functions);

  void set_zero();
  // Adds J^T diag(weight) J of block `block` of function number `function`.
  void add(int function, int block, const BlockValue& value, int dimension, const double* weight);
  // Adds a matrix of the same pattern.
  void add(const NormalMatrix& other);
  // Adds to one unknown's diagonal entry.
  void add_diagonal(int tile, int unknown, double value) {
    diagonal_[rank_[tile]](unknown, unknown) += value;
  }

  // The lower triangle, its diagonal entries d replaced by d (1 + damping) + floor. Tiles come in
  // an elimination_order: factorize with Ordering::as_given and use solve.
  const SparseMatrix& assemble(double damping, double floor);
  // With the factorization of what was assembled.
  LayoutState solve(const SparseCholesky& cholesky, const LayoutState& right) const;

 private:
  using Block = Eigen::Matrix<double, unknowns_per_tile, unknowns_per_tile>;
  struct Pair {
    int high, low;  // block row and column
  };
  void rank_tiles(const std::vector<const BlockFunction*>& functions);

  std::vector<int> rank_;    // of tiles in the order of elimination: all that follows goes by it
  std::vector<Pair> pairs_;  // sorted by column, then row
  std::vector<std::vector<std::array<int, 3>>>
      slots_;  // per function and block: first, second, pair
  std::vector<Block> diagonal_, off_diagonal_;
  SparseMatrix matrix_;
};

}  // namespace curveups
