// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse symmetric matrices of blocks of at most W x W, one block row for each block of unknowns (a
// tile, a vertex): the one assembler of the project. The pattern is fixed by the pairs of blocks
// that elements join; it orders the elimination, elements add to slots looked up once, and
// right-hand sides and solutions come in the caller's numbering, W rows a block.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {

// Two blocks of unknowns that an element joins; negative where it has none, or none that moves.
using Coupling = std::array<int, 2>;

// Where a coupling's block is stored: in the lower triangle, in the order of elimination.
struct BlockSlot {
  int column = -1;       // of blocks; negative: nowhere
  int below = -1;        // the how-manieth block below the diagonal one; -1: the diagonal
  bool swapped = false;  // its rows are those of the coupling's second block

  bool stored() const { return column >= 0; }
};

class BlockPattern {
 public:
  // free: per block whether it is unknown; the others have no rows.
  BlockPattern(const std::vector<char>& free, const std::vector<Coupling>& couplings);

  int block_count() const { return static_cast<int>(rank_.size()); }
  int free_count() const { return static_cast<int>(start_.size()) - 1; }
  // The block's place in the order of elimination, or -1.
  int rank(int block) const { return rank_[block]; }
  BlockSlot diagonal(int block) const { return {rank_[block], -1, false}; }
  // Of the coupling with this number in the list given.
  const BlockSlot& slot(int coupling) const { return slots_[coupling]; }
  // Ranks of the blocks below the diagonal one of a column, ascending: [begin, end).
  const int* begin(int column) const { return below_.data() + start_[column]; }
  const int* end(int column) const { return below_.data() + start_[column + 1]; }
  // Number of a block that is no diagonal one among all of these.
  int entry(const BlockSlot& slot) const { return start_[slot.column] + slot.below; }

 private:
  std::vector<int> rank_, start_, below_;
  std::vector<BlockSlot> slots_;
};

template <int W>
class BlockMatrix {
 public:
  using Block = Eigen::Matrix<double, W, W>;

  // unknowns: how many of its W unknowns each block has, the first ones; all where it is empty. The
  // others have no rows.
  explicit BlockMatrix(std::shared_ptr<const BlockPattern> pattern,
                       const std::vector<int>& unknowns = {});

  const BlockPattern& pattern() const { return *pattern_; }
  void set_zero();
  // The entries of column c of a stored block; of a diagonal one only those from row c on exist.
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
  // All entries, in an order of their own: to come back to.
  Eigen::VectorXd entries() const { return matrix_.coeffs(); }
  void set_entries(const Eigen::VectorXd& entries) { matrix_.coeffs() = entries; }

  // Cholesky factorization with the diagonal entries d as d (1 + damping) + shift. False where the
  // matrix is not positive definite or not finite.
  bool factorize(double damping = 0, double shift = 0);
  // By the last factorization, for one or more right-hand sides of W rows a block; zero where
  // there is no unknown.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const {
    return unranked(cholesky_.solve(ranked(right)));
  }
  // The matrix times x, in the caller's numbering as well.
  Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;

  // Rows of the free blocks alone, in the order of elimination, and back.
  Eigen::MatrixXd ranked(const Eigen::MatrixXd& x) const;
  Eigen::MatrixXd unranked(const Eigen::MatrixXd& x) const;
  // With ranked rows, by the factor L of the matrix L L^T.
  const SparseCholesky& factor() const { return cholesky_; }

 private:
  using Column = Eigen::Matrix<double, W, 1>;

  int width(int rank) const { return row_[rank + 1] - row_[rank]; }
  // body(column, first row of the caller's, first row in the order of elimination, rows).
  template <class Body>
  void for_free(Eigen::Index columns, const Body& body) const;

  std::shared_ptr<const BlockPattern> pattern_;
  // The first row of each block, in the order of elimination; one more at the end.
  std::vector<int> row_;
  // Of each block below a diagonal one, how far it is below that one's first row.
  std::vector<int> below_;
  SparseMatrix matrix_;
  SparseCholesky cholesky_{Ordering::as_given};
};

}  // namespace curveups
