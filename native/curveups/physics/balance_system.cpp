// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/balance_system.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/disjoint_sets.hpp"

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

}  // namespace

Points3 tile_centres(const TileMesh& tiles) {
  Points3 centres(tiles.tile_count(), 3);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    const auto corners = tiles.mesh.F.row(i);
    centres.row(i) = (tiles.mesh.V.row(corners(0)) + tiles.mesh.V.row(corners(1)) +
                      tiles.mesh.V.row(corners(2))) /
                     3;
  }
  return centres;
}

BalanceSystem::BalanceSystem(std::vector<ContactPoint> points, const Points3& centres, double lever,
                             const std::vector<int>& held)
    : points_(std::move(points)), centres_(centres), lever_(lever) {
  const int tile_count = static_cast<int>(centres.rows());
  basis_.reserve(points_.size());
  DisjointSets joined(tile_count);
  for (const ContactPoint& point : points_) {
    basis_.push_back(make_basis(point.normal));
    joined.unite(point.tile[0], point.tile[1]);
  }
  std::vector<char> supported(tile_count, 0);  // flag of a component, by its root
  for (int tile : held) supported[joined.find(tile)] = 1;
  std::vector<char> free(tile_count, 0);
  for (int i = 0; i < tile_count; ++i) {
    const int root = joined.find(i);
    free[i] = (root != i || supported[root]) && !std::binary_search(held.begin(), held.end(), i);
  }
  std::vector<Coupling> couplings;
  for (const ContactPoint& point : points_) couplings.push_back(point.tile);
  const auto pattern = std::make_shared<const BlockPattern>(free, couplings);
  matrix_ = std::make_unique<BlockMatrix<6>>(pattern);
  rows_ = 6 * pattern->free_count();
  for (int i = 0; i < tile_count; ++i) {
    row_of_tile_.push_back(free[i] ? 6 * pattern->rank(i) : -1);
  }
  make_arms();
}

void BalanceSystem::make_arms() {
  arm_.resize(points_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) {
    for (int end = 0; end < 2; ++end) {
      Arm& out = arm_[p][end];
      const int tile = points_[p].tile[end];
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
      if (row_of_tile_[tile] < 0) continue;
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
      if (row_of_tile_[tile] < 0) continue;
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
      Eigen::Matrix<double, 6, 1> wrench = arm_[p][end] * f.segment<3>(3 * p);
      wrench.tail<3>() *= lever_;
      out.row(tile) += wrench.transpose();
    }
  }
  return out;
}

bool BalanceSystem::factorize(const std::vector<Eigen::Matrix3d>& D) {
  if (rows_ == 0) return true;
  const BlockPattern& pattern = matrix_->pattern();
  matrix_->set_zero();
  for (int p = 0; p < point_count(); ++p) {
    const std::array<Arm, 2>& arms = arm_[p];
    for (int end = 0; end < 2; ++end) {
      const int tile = points_[p].tile[end];
      if (row_of_tile_[tile] < 0) continue;
      matrix_->add(pattern.diagonal(tile), arms[end] * D[p] * arms[end].transpose());
    }
    const BlockSlot& slot = pattern.slot(p);
    if (!slot.stored()) continue;
    const int row = slot.swapped ? 1 : 0;
    matrix_->add(slot, arms[row] * D[p] * arms[1 - row].transpose());
  }
  const double mean = matrix_->mean_diagonal();
  if (!std::isfinite(mean)) return false;
  for (double relative : {0.0, 1e-12, 1e-9}) {
    if (matrix_->factorize(0, relative * mean)) return true;
  }
  return false;
}

WrenchBalance wrench_balance(const Wrenches& wrenches, const Points3& centres, double lever) {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double mean = 0;
  if (wrenches.rows() == 0) return {0, 0};
  const Vec3 origin = centres.colwise().mean();
  for (int i = 0; i < wrenches.rows(); ++i) {
    const Vec3 f = wrenches.row(i).head<3>(), arm = centres.row(i).transpose() - origin;
    force += f;
    torque += wrenches.row(i).tail<3>().transpose() + arm.cross(f);
    mean += f.norm() / static_cast<double>(wrenches.rows());
  }
  if (!(mean > 0)) return {0, 0};
  return {force.cwiseAbs().maxCoeff() / mean, torque.cwiseAbs().maxCoeff() / (lever * mean)};
}

SolverFailure no_balance() {
  return SolverFailure("the tiles' balance could not be solved",
                       "check contact points and forces for numbers that are not finite");
}

}  // namespace curveups
