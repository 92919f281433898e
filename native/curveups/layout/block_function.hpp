// SPDX-License-Identifier: LGPL-2.1-or-later
// What every energy term and every constraint of the layout is: many small vector functions, each
// of the unknowns of one tile or of two.
#pragma once

#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// The most rows of a block's Jacobian.
inline constexpr int largest_block = 8;
using BlockJacobian = Eigen::Matrix<double, largest_block, unknowns_per_tile, Eigen::RowMajor>;

struct BlockValue {
  Eigen::Matrix<double, largest_block, 1> value;
  std::array<BlockJacobian, 2> jacobian;  // by the unknowns of the first and the second tile
};

class BlockFunction {
 public:
  virtual ~BlockFunction() = default;
  virtual std::string_view name() const = 0;
  virtual int block_count() const = 0;
  virtual int dimension() const = 0;
  // The tiles of a block; the second is -1 where it depends on one tile only.
  virtual std::array<int, 2> tiles(int block) const = 0;
  // Rows of the Jacobians beyond dimension() that add curvature to the Gauss-Newton matrix: half
  // the sum of squares (energies), or the function itself (constraints, negated), curves by at
  // least their squares more than first derivatives tell. Without them steps overshoot twofold.
  virtual int curvature_rows() const { return 0; }
  // Fills the first dimension() values; Jacobians, curvature rows included, only where
  // `derivatives`. second is null where the block has one tile.
  virtual void evaluate(int block, const double* first, const double* second, bool derivatives,
                        BlockValue& out) const = 0;
};

using BlockFunctions = std::vector<std::unique_ptr<BlockFunction>>;

// Residuals of Eq. 9 with their weights inside: E = sum of squares. `soft` adds the terms that
// stand in for hard constraints (E_c, E_pa). The functions refer to the model.
BlockFunctions make_energies(const LayoutModel& model, bool soft);

// Hard constraints: every entry of every block must be at least 0. Bounds of insets are not among
// them; PinBounds has them.
BlockFunctions make_constraints(const LayoutModel& model);

double energy(const BlockFunction& function, const LayoutState& state);

// One function per file.
std::unique_ptr<BlockFunction> make_alignment_energy(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_packing_energy(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_spring_energy(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_collision_energy(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_pin_area_energy(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_gap_constraint(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_pin_area_constraint(const LayoutModel& model);
std::unique_ptr<BlockFunction> make_pin_keepout_constraint(const LayoutModel& model);

}  // namespace curveups
