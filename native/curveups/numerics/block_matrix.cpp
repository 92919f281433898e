// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/block_matrix.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/sort_unique.hpp"

namespace curveups {
namespace {

// Coupled blocks of higher number of each block, ascending.
using Above = std::vector<std::vector<int>>;
Above neighbours_above(const std::vector<int>& number, int count,
                       const std::vector<Coupling>& couplings) {
  checkpoint();
  Above above(count);
  for (const auto& [i, j] : couplings) {
    if (i < 0 || j < 0 || number[i] < 0 || number[j] < 0 || i == j) continue;
    above[std::min(number[i], number[j])].push_back(std::max(number[i], number[j]));
  }
  for (std::vector<int>& list : above) sort_unique(list);
  return above;
}

}  // namespace

BlockPattern::BlockPattern(const std::vector<char>& free, const std::vector<Coupling>& couplings)
    : rank_(free.size(), -1), start_(1, 0) {
  int count = 0;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i]) rank_[i] = count++;
  }
  const std::vector<int> order = elimination_order(neighbours_above(rank_, count, couplings));
  std::vector<int> place(count);
  for (int k = 0; k < count; ++k) place[order[k]] = k;
  for (int& rank : rank_) {
    if (rank >= 0) rank = place[rank];
  }
  for (const std::vector<int>& list : neighbours_above(rank_, count, couplings)) {
    below_.insert(below_.end(), list.begin(), list.end());
    start_.push_back(static_cast<int>(below_.size()));
  }
  checkpoint();
  slots_.resize(couplings.size());
  for (std::size_t k = 0; k < couplings.size(); ++k) {
    const auto [i, j] = couplings[k];
    if (i < 0 || j < 0 || rank_[i] < 0 || rank_[j] < 0) continue;
    BlockSlot& slot = slots_[k];
    slot = {std::min(rank_[i], rank_[j]), -1, rank_[i] < rank_[j]};
    if (i == j) continue;
    slot.below = static_cast<int>(
        std::lower_bound(begin(slot.column), end(slot.column), std::max(rank_[i], rank_[j])) -
        begin(slot.column));
  }
}

template <int W>
BlockMatrix<W>::BlockMatrix(std::shared_ptr<const BlockPattern> pattern,
                            const std::vector<int>& unknowns)
    : pattern_(std::move(pattern)) {
  const int blocks = pattern_->free_count();
  row_.assign(blocks + 1, W);
  for (int b = 0; b < static_cast<int>(unknowns.size()); ++b) {
    if (pattern_->rank(b) >= 0) row_[pattern_->rank(b)] = unknowns[b];
  }
  std::exclusive_scan(row_.begin(), row_.end(), row_.begin(), 0);
  Eigen::Index entries = 0;
  for (int b = 0; b < blocks; ++b) {
    int depth = width(b);
    for (const int* u = pattern_->begin(b); u != pattern_->end(b); ++u) {
      below_.push_back(depth);
      depth += width(*u);
    }
    entries += width(b) * depth - width(b) * (width(b) - 1) / 2;
  }
  matrix_.resize(row_[blocks], row_[blocks]);
  matrix_.resizeNonZeros(entries);
  int at = 0;
  for (int b = 0; b < blocks; ++b) {
    for (int c = row_[b]; c < row_[b + 1]; ++c) {
      matrix_.outerIndexPtr()[c] = at;
      for (int r = c; r < row_[b + 1]; ++r) matrix_.innerIndexPtr()[at++] = r;
      for (const int* u = pattern_->begin(b); u != pattern_->end(b); ++u) {
        for (int r = row_[*u]; r < row_[*u + 1]; ++r) matrix_.innerIndexPtr()[at++] = r;
      }
    }
  }
  matrix_.outerIndexPtr()[row_[blocks]] = at;
  set_zero();
}

template <int W>
void BlockMatrix<W>::set_zero() {
  std::fill(matrix_.valuePtr(), matrix_.valuePtr() + matrix_.nonZeros(), 0.0);
}

template <int W>
void BlockMatrix<W>::add(const BlockMatrix& other) {
  matrix_.coeffs() += other.matrix_.coeffs();
}

template <int W>
double BlockMatrix<W>::mean_diagonal() const {
  return matrix_.diagonal().mean();
}

template <int W>
bool BlockMatrix<W>::factorize(double damping, double shift) {
  const Eigen::VectorXd kept = matrix_.diagonal();
  auto entry = [&](Eigen::Index i) -> double& {
    return matrix_.valuePtr()[matrix_.outerIndexPtr()[i]];
  };
  for (Eigen::Index i = 0; i < kept.size(); ++i) entry(i) = kept(i) * (1 + damping) + shift;
  const bool done = cholesky_.factorize(matrix_);
  for (Eigen::Index i = 0; i < kept.size(); ++i) entry(i) = kept(i);
  return done;
}

template <int W>
std::vector<Eigen::Matrix<double, W, W>> BlockMatrix<W>::inverse_diagonal() const {
  const int count = pattern_->free_count();
  std::vector<Block> inverse(count);
  for (int b = 0; b < count; ++b) {
    // Other rows of narrow blocks are those of the identity.
    Block own = Block::Identity();
    for (int c = 0; c < width(b); ++c) {
      const double* column = matrix_.valuePtr() + matrix_.outerIndexPtr()[row_[b] + c] - c;
      for (int r = c; r < width(b); ++r) own(r, c) = own(c, r) = column[r];
    }
    const Eigen::LLT<Block> cholesky(own);
    inverse[b] = cholesky.info() == Eigen::Success ? Block(cholesky.solve(Block::Identity()))
                                                   : Block(Block::Identity() / own.norm());
  }
  return inverse;
}

template <int W>
Eigen::VectorXd BlockMatrix<W>::solve_iteratively(const Eigen::VectorXd& right,
                                                  double tolerance) const {
  const std::vector<Block> inverse = inverse_diagonal();
  Eigen::VectorXd residual = ranked(right), preconditioned(residual.size()),
                  x = Eigen::VectorXd::Zero(residual.size()), direction, product;
  const double goal = tolerance * residual.norm();
  double slope = 0;
  for (Eigen::Index k = 0; k < residual.size() && residual.norm() > goal; ++k) {
    for (std::size_t b = 0; b < inverse.size(); ++b) {
      const int row = row_[b], rows = width(static_cast<int>(b));
      preconditioned.segment(row, rows).noalias() =
          inverse[b].topLeftCorner(rows, rows) * residual.segment(row, rows);
    }
    const double next = residual.dot(preconditioned);
    direction = k == 0 ? preconditioned : preconditioned + next / slope * direction;
    slope = next;
    product.noalias() = matrix_.template selfadjointView<Eigen::Lower>() * direction;
    const double curvature = direction.dot(product);
    if (!(curvature > 0)) {
      if (k == 0) x = direction;
      break;
    }
    x += slope / curvature * direction;
    residual -= slope / curvature * product;
  }
  return unranked(x);
}

// Goes column by column, as these are long.
template <int W>
template <class Body>
void BlockMatrix<W>::for_free(Eigen::Index columns, const Body& body) const {
  for (Eigen::Index c = 0; c < columns; ++c) {
    for (int b = 0; b < pattern_->block_count(); ++b) {
      const int rank = pattern_->rank(b);
      if (rank >= 0) body(c, W * b, row_[rank], width(rank));
    }
  }
}

template <int W>
Eigen::MatrixXd BlockMatrix<W>::ranked(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd out(matrix_.rows(), x.cols());
  for_free(x.cols(), [&](Eigen::Index c, int own, int row, int count) {
    out.col(c).segment(row, count) = x.col(c).segment(own, count);
  });
  return out;
}

template <int W>
Eigen::MatrixXd BlockMatrix<W>::unranked(const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(W * pattern_->block_count(), x.cols());
  for_free(x.cols(), [&](Eigen::Index c, int own, int row, int count) {
    out.col(c).segment(own, count) = x.col(c).segment(row, count);
  });
  return out;
}

template <int W>
Eigen::MatrixXd BlockMatrix<W>::multiply(const Eigen::MatrixXd& x) const {
  return unranked(matrix_.template selfadjointView<Eigen::Lower>() * ranked(x));
}

template class BlockMatrix<1>;
template class BlockMatrix<3>;
template class BlockMatrix<6>;
template class BlockMatrix<9>;

}  // namespace curveups
