// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/balance_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace curveups {
namespace {

Eigen::Matrix3d make_basis(const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().minCoeff(&axis);
  Eigen::Matrix3d basis;
  basis.col(0) = normal;
  basis.col(1) = normal.cross(Vec3::Unit(axis)).normalized();
  basis.col(2) = normal.cross(basis.col(1));
  return basis;
}

// Union-find over tiles, the lowest tile of a component as its root.
int root_of(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

BalanceSystem::BalanceSystem(std::vector<ContactPoint> points, const Points3& centres, double lever,
                             const std::vector<int>& held)
    : points_(std::move(points)), centres_(centres), lever_(lever) {
  const int tile_count = static_cast<int>(centres.rows());
  basis_.reserve(points_.size());
  std::vector<int> parent(tile_count);
  std::iota(parent.begin(), parent.end(), 0);
  for (const ContactPoint& point : points_) {
    basis_.push_back(make_basis(point.normal));
    if (point.tile[0] < 0) continue;
    const int a = root_of(parent, point.tile[0]), b = root_of(parent, point.tile[1]);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<char> supported(tile_count, 0);  // by component root
  for (const ContactPoint& point : points_) {
    if (point.tile[0] < 0) supported[root_of(parent, point.tile[1])] = 1;
  }
  for (int tile : held) supported[root_of(parent, tile)] = 1;
  row_of_tile_.assign(tile_count, -1);
  for (int i = 0; i < tile_count; ++i) {
    const int root = root_of(parent, i);
    if (root == i && !supported[root]) continue;
    if (std::binary_search(held.begin(), held.end(), i)) continue;
    row_of_tile_[i] = rows_;
    rows_ += 6;
  }
  number_rows();
  make_pattern();
  make_arms();
}

std::array<int, 2> BalanceSystem::blocks_of(const ContactPoint& point) const {
  std::array<int, 2> block = {-1, -1};
  for (int end = 0; end < 2; ++end) {
    const int tile = point.tile[end];
    if (tile >= 0 && row_of_tile_[tile] >= 0) block[end] = row_of_tile_[tile] / 6;
  }
  return block;
}

std::vector<std::vector<int>> BalanceSystem::neighbours_above() const {
  std::vector<std::vector<int>> above(rows_ / 6);
  for (const ContactPoint& point : points_) {
    const auto [a, b] = blocks_of(point);
    if (a >= 0 && b >= 0) above[std::min(a, b)].push_back(std::max(a, b));
  }
  for (std::vector<int>& list : above) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return above;
}

void BalanceSystem::number_rows() {
  const std::vector<int> order = elimination_order(neighbours_above());
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = static_cast<int>(k);
  for (int& row : row_of_tile_) {
    if (row >= 0) row = 6 * number[row / 6];
  }
}

void BalanceSystem::make_pattern() {
  const int blocks = rows_ / 6;
  const std::vector<std::vector<int>> above = neighbours_above();
  int entries = 0;
  for (const std::vector<int>& list : above) entries += 21 + 36 * static_cast<int>(list.size());
  matrix_.resize(rows_, rows_);
  matrix_.resizeNonZeros(entries);
  int at = 0;
  for (int v = 0; v < blocks; ++v) {
    for (int c = 0; c < 6; ++c) {
      matrix_.outerIndexPtr()[6 * v + c] = at;
      for (int r = c; r < 6; ++r) matrix_.innerIndexPtr()[at++] = 6 * v + r;
      for (int u : above[v]) {
        for (int r = 0; r < 6; ++r) matrix_.innerIndexPtr()[at++] = 6 * u + r;
      }
    }
  }
  matrix_.outerIndexPtr()[rows_] = at;
  offset_.assign(points_.size(), -1);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const auto [a, b] = blocks_of(points_[p]);
    if (a < 0 || b < 0) continue;
    const std::vector<int>& list = above[std::min(a, b)];
    offset_[p] = 6 * static_cast<int>(std::lower_bound(list.begin(), list.end(), std::max(a, b)) -
                                      list.begin());
  }
}

void BalanceSystem::make_arms() {
  arm_.resize(points_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) {
    for (int end = 0; end < 2; ++end) {
      Arm& out = arm_[p][end];
      const int tile = points_[p].tile[end];
      if (tile < 0) {
        out.setZero();
        continue;
      }
      const double sign = end == 0 ? -1.0 : 1.0;
      const Vec3 r = points_[p].position - centres_.row(tile).transpose();
      out.topRows<3>() = sign * basis_[p];
      for (int c = 0; c < 3; ++c) {
        out.block<3, 1>(3, c) = (sign / lever_) * r.cross(basis_[p].col(c));
      }
    }
  }
}

Eigen::VectorXd BalanceSystem::restrict(const Wrenches& wrenches) const {
  Eigen::VectorXd out(rows_);
  for (int i = 0; i < wrenches.rows(); ++i) {
    if (row_of_tile_[i] < 0) continue;
    out.segment<3>(row_of_tile_[i]) = wrenches.row(i).head<3>().transpose();
    out.segment<3>(row_of_tile_[i] + 3) = wrenches.row(i).tail<3>().transpose() / lever_;
  }
  return out;
}

Eigen::VectorXd BalanceSystem::apply(const Eigen::VectorXd& f) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(rows_);
  for (int p = 0; p < point_count(); ++p) {
    for (int end = 0; end < 2; ++end) {
      const int tile = points_[p].tile[end];
      if (tile < 0 || row_of_tile_[tile] < 0) continue;
      out.segment<6>(row_of_tile_[tile]).noalias() += arm_[p][end] * f.segment<3>(3 * p);
    }
  }
  return out;
}

Eigen::VectorXd BalanceSystem::apply_transposed(const Eigen::VectorXd& y) const {
  Eigen::VectorXd out = Eigen::VectorXd::Zero(3 * point_count());
  for (int p = 0; p < point_count(); ++p) {
    for (int end = 0; end < 2; ++end) {
      const int tile = points_[p].tile[end];
      if (tile < 0 || row_of_tile_[tile] < 0) continue;
      out.segment<3>(3 * p).noalias() +=
          arm_[p][end].transpose() * y.segment<6>(row_of_tile_[tile]);
    }
  }
  return out;
}

Array6 BalanceSystem::expand(const Eigen::VectorXd& y) const {
  Array6 out = Array6::Zero(centres_.rows(), 6);
  for (int i = 0; i < out.rows(); ++i) {
    if (row_of_tile_[i] >= 0) out.row(i) = y.segment<6>(row_of_tile_[i]).transpose();
  }
  return out;
}

Wrenches BalanceSystem::wrenches(const Eigen::VectorXd& f) const {
  Wrenches out = Wrenches::Zero(centres_.rows(), 6);
  for (int p = 0; p < point_count(); ++p) {
    for (int end = 0; end < 2; ++end) {
      const int tile = points_[p].tile[end];
      if (tile < 0) continue;
      Vector6 wrench = arm_[p][end] * f.segment<3>(3 * p);
      wrench.tail<3>() *= lever_;
      out.row(tile) += wrench.transpose();
    }
  }
  return out;
}

bool BalanceSystem::factorize(const std::vector<Eigen::Matrix3d>& D) {
  if (rows_ == 0) return true;
  double* values = matrix_.valuePtr();
  const int* outer = matrix_.outerIndexPtr();
  std::fill(values, values + matrix_.nonZeros(), 0.0);
  for (int p = 0; p < point_count(); ++p) {
    std::array<int, 2> row = {-1, -1};
    const std::array<Arm, 2>& arms = arm_[p];
    for (int end = 0; end < 2; ++end) {
      const int tile = points_[p].tile[end];
      if (tile < 0 || row_of_tile_[tile] < 0) continue;
      row[end] = row_of_tile_[tile];
      const Matrix6 block = arms[end] * D[p] * arms[end].transpose();
      for (int c = 0; c < 6; ++c) {
        for (int r = c; r < 6; ++r) values[outer[row[end] + c] + r - c] += block(r, c);
      }
    }
    if (offset_[p] < 0) continue;
    const int low = row[0] < row[1] ? 0 : 1, high = 1 - low;
    const Matrix6 pair = arms[high] * D[p] * arms[low].transpose();
    for (int c = 0; c < 6; ++c) {
      double* to = values + outer[row[low] + c] + 6 - c + offset_[p];
      for (int r = 0; r < 6; ++r) to[r] += pair(r, c);
    }
  }
  if (factor_.factorize(matrix_)) return true;
  const double mean = matrix_.diagonal().mean();
  if (!std::isfinite(mean)) return false;
  for (double relative : {1e-12, 1e-9}) {
    for (int i = 0; i < rows_; ++i) values[outer[i]] += relative * mean;
    if (factor_.factorize(matrix_)) return true;
  }
  return false;
}

Eigen::MatrixXd BalanceSystem::solve(const Eigen::MatrixXd& rhs) const {
  if (rows_ == 0) return rhs;
  return factor_.solve(rhs);
}

}  // namespace curveups
