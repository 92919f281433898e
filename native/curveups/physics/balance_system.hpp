// SPDX-License-Identifier: LGPL-2.1-or-later
// Force and torque balance of all tiles under point contacts (paper, Eq. 2): A f + b = 0, f the
// contact forces, b the other wrenches. Torques are divided by a lever so that all rows are forces.
// Per connected component without a held tile, the six rows of one tile are left out: they follow
// from the others. Owns the factorization of A D A^T.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/design/tile_mesh.hpp"
#include "curveups/numerics/block_matrix.hpp"
#include "curveups/numerics/cone_program.hpp"

namespace curveups {

// M x 6: force (N) and torque (N mm) on each tile, the torque about the tile's centre.
using Wrenches = Array6;

// Reference points of torques: the centroids of the front triangles, M x 3.
Points3 tile_centres(const TileMesh& tiles);

// A point at which tile[0] pushes tile[1] along `normal` (unit), and tile[1] pushes back.
struct ContactPoint {
  Vec3 position;
  Vec3 normal;
  std::array<int, 2> tile;
  int contact;  // number of its contact, for reports
};

// Forces are three numbers per point in the point's own basis: along the normal (pushing positive)
// and two tangents.
class BalanceSystem : public ForceMap {
 public:
  // centres: tile_centres. held: tiles that something else holds in balance, ascending.
  BalanceSystem(std::vector<ContactPoint> points, const Points3& centres, double lever,
                const std::vector<int>& held);

  const std::vector<ContactPoint>& points() const { return points_; }
  const Points3& centres() const { return centres_; }
  int point_count() const override { return static_cast<int>(points_.size()); }
  int rows() const override { return rows_; }
  // False for held tiles and for the one left out per component.
  bool has_rows(int tile) const { return row_of_tile_[tile] >= 0; }
  // First of a tile's six rows.
  int first_row(int tile) const { return row_of_tile_[tile]; }
  // Columns: normal and tangents of a point.
  const Eigen::Matrix3d& basis(int point) const { return basis_[point]; }
  double lever() const { return lever_; }

  // Rows of wrenches (M x 6, torques about the centres).
  Eigen::VectorXd restrict(const Wrenches& wrenches) const;
  Eigen::VectorXd apply(const Eigen::VectorXd& f) const override;
  Eigen::VectorXd apply_transposed(const Eigen::VectorXd& y) const override;
  // Multipliers of the rows as M x 6, zero where a tile has no rows: virtual velocities of the
  // tiles (the lower three are turns times the lever).
  Array6 expand(const Eigen::VectorXd& y) const;
  // Wrenches of contact forces on all tiles, also on those without rows.
  Wrenches wrenches(const Eigen::VectorXd& f) const;

  // Factorize A D A^T, D symmetric positive definite 3 x 3 per point. Where points are too few to
  // hold a tile the matrix is singular: a small multiple of the identity then makes it solvable.
  // Returns false where even that fails (D not finite).
  bool factorize(const std::vector<Eigen::Matrix3d>& D) override;
  // For one or more right-hand sides.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const override {
    return rows_ == 0 ? rhs : matrix_->factor().solve(rhs);
  }

 private:
  using Arm = Eigen::Matrix<double, 6, 3>;  // force in the basis to wrench on a tile
  void make_arms();

  std::vector<ContactPoint> points_;
  std::vector<Eigen::Matrix3d> basis_;
  std::vector<std::array<Arm, 2>> arm_;  // per point, on its two tiles
  Points3 centres_;
  double lever_;
  std::vector<int> row_of_tile_;  // first row, in the order of elimination, or -1
  int rows_ = 0;
  std::unique_ptr<BlockMatrix<6>> matrix_;  // a block for each tile, a coupling for each point
};

// Largest absolute sum over all tiles of the forces, and of the torques about one point divided by
// `lever`, relative to the mean force on a tile.
struct WrenchBalance {
  double force, torque;
};
WrenchBalance wrench_balance(const Wrenches& wrenches, const Points3& centres, double lever);

// Error for a system that can't be factorized.
SolverFailure no_balance();

}  // namespace curveups
