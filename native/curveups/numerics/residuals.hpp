// SPDX-License-Identifier: LGPL-2.1-or-later
// Many small vector functions r_e, each of the nine unknowns of one tile or of two and of at most
// eight rows: as an energy half the sum of their squares, with its Gauss-Newton matrix; as a
// constraint r_e(x) >= 0.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>
#include <vector>

#include "curveups/core/parallel.hpp"
#include "curveups/numerics/block_matrix.hpp"

namespace curveups {

class Residuals {
 public:
  static constexpr int width = 9, max_rows = 8;
  using Vector = BlockVector<width>;
  using Blocks = Coupling;
  using Unknowns = std::array<const double*, 2>;  // per block of an element; null: no second one
  struct Value {
    Eigen::Matrix<double, max_rows, 1> value;
    std::array<Eigen::Matrix<double, max_rows, width, Eigen::RowMajor>, 2> jacobian;  // per block
  };

  virtual ~Residuals() = default;
  virtual std::string_view name() const = 0;
  virtual int element_count() const = 0;
  // Number of rows of an element's value.
  virtual int dimension() const = 0;
  // Blocks of an element; the second is -1 where there is none.
  virtual Blocks blocks(int element) const = 0;
  // Number of rows of the Jacobians beyond dimension() whose squares add curvature to the
  // Gauss-Newton matrix: a lower bound of the neglected curvature of half the sum of squares
  // (energies) or of the negated function (constraints). Without them steps overshoot twofold.
  virtual int curvature_rows() const { return 0; }
  // Fills the first dimension() values; Jacobians, curvature rows included, only where
  // `derivatives`.
  virtual void evaluate(int element, const Unknowns& x, bool derivatives, Value& out) const = 0;

  void at(int element, const Vector& x, bool derivatives, Value& out) const {
    Unknowns own;
    const Blocks list = blocks(element);
    for (int k = 0; k < 2; ++k) own[k] = list[k] < 0 ? nullptr : x.row(list[k]).data();
    evaluate(element, own, derivatives, out);
  }

  // Appends the pairs of blocks that elements join. derivatives() fills their slots.
  void couple(std::vector<Coupling>& couplings) const {
    for (int e = 0; e < element_count(); ++e) couplings.push_back(blocks(e));
  }
  double value(const Vector& x) const {
    return 0.5 * parallel_sum(element_count(), [&](int e) {
             Value out;
             at(e, x, false, out);
             return out.value.head(dimension()).squaredNorm();
           });
  }

  // Adds to the gradient and, where it is not null, to the Gauss-Newton matrix. first: number of
  // the first coupling in the matrix's pattern. Returns the value.
  double derivatives(const Vector& x, Vector& gradient, BlockMatrix<width>* hessian,
                     int first) const {
    double sum = 0;
    const std::array<double, max_rows> ones = [] {
      std::array<double, max_rows> out;
      out.fill(1);
      return out;
    }();
    const int rows = dimension();
    parallel_gather<Value>(
        element_count(), [&](int e, Value& out) { at(e, x, true, out); },
        [&](int e, const Value& out) {
          sum += out.value.head(rows).squaredNorm();
          for (int r = 0; r < rows; ++r) add_row(e, out, r, out.value(r), gradient);
          if (hessian) add_products(e, out, rows + curvature_rows(), ones.data(), first, *hessian);
        });
    return 0.5 * sum;
  }

  // sum += factor times row `row` of an element's Jacobians.
  void add_row(int element, const Value& value, int row, double factor, Vector& sum) const {
    const Blocks list = blocks(element);
    for (int k = 0; k < 2 && list[k] >= 0; ++k) {
      sum.row(list[k]) += factor * value.jacobian[k].row(row);
    }
  }
  // Row `row` of an element's Jacobians times a step.
  double dot_row(int element, const Value& value, int row, const Vector& step) const {
    const Blocks list = blocks(element);
    double sum = value.jacobian[0].row(row).dot(step.row(list[0]));
    if (list[1] >= 0) sum += value.jacobian[1].row(row).dot(step.row(list[1]));
    return sum;
  }
  // Adds J^T diag(weight) J of the first `rows` rows; first as in derivatives().
  void add_products(int element, const Value& value, int rows, const double* weight, int first,
                    BlockMatrix<width>& matrix) const {
    const Blocks list = blocks(element);
    const BlockSlot& joint = matrix.pattern().slot(first + element);
    for (int r = 0; r < rows; ++r) {
      for (int k = 0; k < 2 && list[k] >= 0; ++k) {
        const double* own = value.jacobian[k].row(r).data();
        add_product(own, own, weight[r], matrix.pattern().diagonal(list[k]), matrix);
      }
      if (!joint.stored()) continue;
      const double *a = value.jacobian[0].row(r).data(), *b = value.jacobian[1].row(r).data();
      add_product(joint.swapped ? b : a, joint.swapped ? a : b, weight[r], joint, matrix);
    }
  }

 private:
  // Most rows touch a few unknowns only: zeros are skipped.
  static void add_product(const double* row, const double* column, double weight,
                          const BlockSlot& slot, BlockMatrix<width>& matrix) {
    for (int c = 0; c < width; ++c) {
      if (column[c] == 0) continue;
      const double scaled = weight * column[c];
      double* to = matrix.column(slot, c);
      for (int r = slot.below < 0 ? c : 0; r < width; ++r) to[r] += scaled * row[r];
    }
  }
};

using ResidualsList = std::vector<std::unique_ptr<Residuals>>;

// Largest violation of constraints.
inline double largest_violation(const ResidualsList& constraints, const Residuals::Vector& x) {
  double largest = 0;
  Residuals::Value value;
  for (const auto& constraint : constraints) {
    for (int e = 0; e < constraint->element_count(); ++e) {
      constraint->at(e, x, false, value);
      largest = std::max(largest, -value.value.head(constraint->dimension()).minCoeff());
    }
  }
  return largest;
}

}  // namespace curveups
