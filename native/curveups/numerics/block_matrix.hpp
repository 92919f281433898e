// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse symmetric matrices of blocks of at most W x W, one block row for each block of unknowns (a
// tile, a vertex). The pairs of blocks that elements join fix the pattern and its order of
// elimination; elements add to slots that are looked up once. Right-hand sides and solutions come
// in the caller's numbering, W rows a block.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {

// A row for each block, stored row by row.
template <int W>
using BlockVector =
    Eigen::Matrix<double, Eigen::Dynamic, W, W == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

// Two blocks of unknowns that an element joins; negative: none.
using Coupling = std::array<int, 2>;

// Place of a coupling's block in the lower triangle, in the order of elimination.
struct BlockSlot {
  int column = -1;       // block column; negative: not stored
  int below = -1;        // number of the block below the diagonal one; -1: the diagonal
  bool swapped = false;  // rows are those of the coupling's second block

  bool stored() const { return column >= 0; }
};

class BlockPattern {
 public:
  // free: per block, not 0 where it is unknown; other blocks have no rows.
  BlockPattern(const std::vector<char>& free, const std::vector<Coupling>& couplings);

  int block_count() const { return static_cast<int>(rank_.size()); }
  int free_count() const { return static_cast<int>(start_.size()) - 1; }
  // Place of a block in the order of elimination, or -1.
  int rank(int block) const { return rank_[block]; }
  BlockSlot diagonal(int block) const { return {rank_[block], -1, false}; }
  // Slot of the coupling with this number in the list given.
  const BlockSlot& slot(int coupling) const { return slots_[coupling]; }
  // Ranks of the blocks below the diagonal one of a column, ascending: [begin, end).
  const int* begin(int column) const { return below_.data() + start_[column]; }
  const int* end(int column) const { return below_.data() + start_[column + 1]; }
  // Number of an off-diagonal block among all of these.
  int entry(const BlockSlot& slot) const { return start_[slot.column] + slot.below; }

 private:
  std::vector<int> rank_, start_, below_;
  std::vector<BlockSlot> slots_;
};

template <int W>
class BlockMatrix {
 public:
  using Block = Eigen::Matrix<double, W, W>;

  // unknowns: number of leading unknowns that each block has, at most W; empty: W. Others have no
  // rows.
  explicit BlockMatrix(std::shared_ptr<const BlockPattern> pattern,
                       const std::vector<int>& unknowns = {});

  const BlockPattern& pattern() const { return *pattern_; }
  void set_zero();
  // Entries of column c of a stored block; those of a diagonal block exist from row c on.
  double* column(const BlockSlot& slot, int c) {
    return matrix_.valuePtr() + matrix_.outerIndexPtr()[row_[slot.column] + c] - c +
           (slot.below < 0 ? 0 : below_[pattern_->entry(slot)]);
  }
  // block: with the slot's rows (BlockSlot::swapped).
  void add(const BlockSlot& slot, const Block& block) {
    const bool own = slot.below < 0;
    const int columns = width(slot.column),
              rows = own ? columns : width(pattern_->begin(slot.column)[slot.below]);
    if (!own && rows == W && columns == W) {
      for (int c = 0; c < W; ++c) Eigen::Map<Column>(column(slot, c)) += block.col(c);
      return;
    }
    for (int c = 0; c < columns; ++c) {
      double* to = column(slot, c);
      for (int r = own ? c : 0; r < rows; ++r) to[r] += block(r, c);
    }
  }
  double& diagonal(int block, int unknown) {
    return column(pattern_->diagonal(block), unknown)[unknown];
  }
  // Adds a matrix of the same pattern and unknowns.
  void add(const BlockMatrix& other);
  double mean_diagonal() const;

  // Cholesky factorization with the diagonal entries d as d (1 + damping) + shift; the mean of the
  // diagonal is a unit for the latter.
  // False where the matrix is not positive definite or not finite. The matrix itself stays as it
  // is, so that it can be factorized again with more damping.
  // Throws SolverFailure where memory runs out.
  bool factorize(double damping = 0, double shift = 0);
  // Solution by the last factorization, for one or more right-hand sides of W rows a block; zero
  // where there is no unknown.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const {
    return unranked(cholesky_.solve(ranked(right)));
  }
  // Approximate solution by conjugate gradients, which needs no factorization: good for matrices
  // that the inverses of their diagonal blocks precondition well. Ends where the residual's norm is
  // `tolerance` of the right side's, or at a direction without positive curvature, of which it
  // keeps the first alone: a descent direction of Newton's method (truncated Newton, Nocedal and
  // Wright, Numerical Optimization, 7.1).
  Eigen::VectorXd solve_iteratively(const Eigen::VectorXd& right, double tolerance) const;
  // Product with x, in the caller's numbering as well.
  Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;

  // Rows of the free blocks alone, in the order of elimination, and back.
  Eigen::MatrixXd ranked(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd unranked(const Eigen::MatrixXd& x) const;
  // Factor L of the matrix L L^T, for ranked rows.
  const SparseCholesky& factor() const { return cholesky_; }

 private:
  using Column = Eigen::Matrix<double, W, 1>;

  // Inverses of the diagonal blocks, by rank; a multiple of the identity where one is indefinite.
  std::vector<Block> inverse_diagonal() const;
  int width(int rank) const { return row_[rank + 1] - row_[rank]; }
  // Calls body(column, first row of the caller, first row in the order of elimination, rows).
  template <class Body>
  void for_free(Eigen::Index columns, const Body& body) const;

  std::shared_ptr<const BlockPattern> pattern_;
  // First row of each block, in the order of elimination, and the end.
  std::vector<int> row_;
  // Rows from the first one of the diagonal block to each block below it.
  std::vector<int> below_;
  SparseMatrix matrix_;
  SparseCholesky cholesky_{Ordering::as_given};
};

}  // namespace curveups
