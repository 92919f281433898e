// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/normal_matrix.hpp"

#include <algorithm>

namespace curveups {

void NormalMatrix::rank_tiles(const std::vector<const BlockFunction*>& functions) {
  std::vector<std::vector<int>> above(rank_.size());
  for (const BlockFunction* function : functions) {
    for (int b = 0; b < function->block_count(); ++b) {
      const auto [i, j] = function->tiles(b);
      if (j >= 0) above[std::min(i, j)].push_back(std::max(i, j));
    }
  }
  for (std::vector<int>& row : above) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  const std::vector<int> order = elimination_order(above);
  for (std::size_t k = 0; k < order.size(); ++k) rank_[order[k]] = static_cast<int>(k);
}

NormalMatrix::NormalMatrix(int tile_count, const std::vector<const BlockFunction*>& functions)
    : rank_(tile_count), diagonal_(tile_count) {
  constexpr int n = unknowns_per_tile;
  rank_tiles(functions);
  auto ranks = [&](const BlockFunction& function, int block) {
    const auto [i, j] = function.tiles(block);
    return std::array<int, 2>{rank_[i], j < 0 ? -1 : rank_[j]};
  };
  auto before = [](const Pair& a, const Pair& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  };
  for (const BlockFunction* function : functions) {
    for (int b = 0; b < function->block_count(); ++b) {
      const auto [i, j] = ranks(*function, b);
      if (j >= 0) pairs_.push_back({std::max(i, j), std::min(i, j)});
    }
  }
  std::sort(pairs_.begin(), pairs_.end(), before);
  pairs_.erase(
      std::unique(pairs_.begin(), pairs_.end(),
                  [](const Pair& a, const Pair& b) { return a.high == b.high && a.low == b.low; }),
      pairs_.end());
  off_diagonal_.resize(pairs_.size());
  for (const BlockFunction* function : functions) {
    std::vector<std::array<int, 3>> slots(function->block_count());
    for (int b = 0; b < function->block_count(); ++b) {
      const auto [i, j] = ranks(*function, b);
      int pair = -1;
      if (j >= 0) {
        const Pair key{std::max(i, j), std::min(i, j)};
        pair = static_cast<int>(std::lower_bound(pairs_.begin(), pairs_.end(), key, before) -
                                pairs_.begin());
      }
      slots[b] = {i, j, pair};
    }
    slots_.push_back(std::move(slots));
  }
  // Column c of block column j: rows c to 8 of the diagonal block, then the blocks below it.
  matrix_.resize(static_cast<Eigen::Index>(tile_count) * n,
                 static_cast<Eigen::Index>(tile_count) * n);
  std::vector<int> below(tile_count + 1, 0);
  for (const Pair& pair : pairs_) ++below[pair.low + 1];
  for (int j = 0; j < tile_count; ++j) below[j + 1] += below[j];
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(tile_count) * n * (n + 1) / 2 +
                         static_cast<Eigen::Index>(pairs_.size()) * n * n);
  int entry = 0;
  for (int j = 0; j < tile_count; ++j) {
    for (int c = 0; c < n; ++c) {
      matrix_.outerIndexPtr()[j * n + c] = entry;
      for (int r = c; r < n; ++r) matrix_.innerIndexPtr()[entry++] = j * n + r;
      for (int p = below[j]; p < below[j + 1]; ++p) {
        for (int r = 0; r < n; ++r) matrix_.innerIndexPtr()[entry++] = pairs_[p].high * n + r;
      }
    }
  }
  matrix_.outerIndexPtr()[tile_count * n] = entry;
}

void NormalMatrix::set_zero() {
  for (Block& block : diagonal_) block.setZero();
  for (Block& block : off_diagonal_) block.setZero();
}

namespace {

// block += weight a^T b. Most rows touch a pose or a few insets only: zeros are skipped.
template <class Block>
void add_outer(const double* a, const double* b, double weight, Block& block) {
  for (int c = 0; c < unknowns_per_tile; ++c) {
    if (b[c] == 0) continue;
    const double scaled = weight * b[c];
    double* column = block.data() + c * unknowns_per_tile;
    for (int r = 0; r < unknowns_per_tile; ++r) column[r] += scaled * a[r];
  }
}

}  // namespace

void NormalMatrix::add(int function, int block, const BlockValue& value, int dimension,
                       const double* weight) {
  const auto [i, j, pair] = slots_[function][block];
  for (int r = 0; r < dimension; ++r) {
    const double* a = value.jacobian[0].row(r).data();
    add_outer(a, a, weight[r], diagonal_[i]);
    if (j < 0) continue;
    const double* b = value.jacobian[1].row(r).data();
    add_outer(b, b, weight[r], diagonal_[j]);
    if (i > j) {
      add_outer(a, b, weight[r], off_diagonal_[pair]);
    } else {
      add_outer(b, a, weight[r], off_diagonal_[pair]);
    }
  }
}

void NormalMatrix::add(const NormalMatrix& other) {
  for (std::size_t k = 0; k < diagonal_.size(); ++k) diagonal_[k] += other.diagonal_[k];
  for (std::size_t k = 0; k < off_diagonal_.size(); ++k) off_diagonal_[k] += other.off_diagonal_[k];
}

const SparseMatrix& NormalMatrix::assemble(double damping, double floor) {
  constexpr int n = unknowns_per_tile;
  double* value = matrix_.valuePtr();
  std::size_t p = 0;
  for (int j = 0; j < static_cast<int>(diagonal_.size()); ++j) {
    std::size_t end = p;
    while (end < pairs_.size() && pairs_[end].low == j) ++end;
    for (int c = 0; c < n; ++c) {
      *value++ = diagonal_[j](c, c) * (1 + damping) + floor;
      for (int r = c + 1; r < n; ++r) *value++ = diagonal_[j](r, c);
      for (std::size_t k = p; k < end; ++k) {
        for (int r = 0; r < n; ++r) *value++ = off_diagonal_[k](r, c);
      }
    }
    p = end;
  }
  return matrix_;
}

LayoutState NormalMatrix::solve(const SparseCholesky& cholesky, const LayoutState& right) const {
  LayoutState ranked(right.rows(), unknowns_per_tile), out(right.rows(), unknowns_per_tile);
  for (std::size_t i = 0; i < rank_.size(); ++i) {
    ranked.row(rank_[i]) = right.row(static_cast<Eigen::Index>(i));
  }
  const Eigen::VectorXd solution =
      cholesky.solve(Eigen::Map<const Eigen::VectorXd>(ranked.data(), ranked.size()));
  ranked = Eigen::Map<const LayoutState>(solution.data(), right.rows(), unknowns_per_tile);
  for (std::size_t i = 0; i < rank_.size(); ++i) {
    out.row(static_cast<Eigen::Index>(i)) = ranked.row(rank_[i]);
  }
  return out;
}

}  // namespace curveups
