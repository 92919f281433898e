// SPDX-License-Identifier: LGPL-2.1-or-later
// Interface of energies: functions of blocks of W unknowns each (nine of a tile, three of a vertex)
// with value, gradient, second derivatives and longest step. Solvers, merit functions and the
// finite-difference test see nothing else.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "curveups/numerics/block_matrix.hpp"

namespace curveups {

// A row for each block, stored row by row.
template <int W>
using BlockVector =
    Eigen::Matrix<double, Eigen::Dynamic, W, W == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

template <int W>
class Term {
 public:
  virtual ~Term() = default;
  virtual std::string_view name() const = 0;
  // Appends the pairs of blocks that elements join. derivatives() fills their slots.
  virtual void couple(std::vector<Coupling>& couplings) const = 0;
  virtual double value(const BlockVector<W>& x) const = 0;
  // Adds to the gradient and, where it is not null, to the matrix of second derivatives: exact
  // ones, or a Gauss-Newton matrix near them. first: number of the term's first coupling in the
  // matrix's pattern. Returns the value.
  virtual double derivatives(const BlockVector<W>& x, BlockVector<W>& gradient,
                             BlockMatrix<W>* hessian, int first) const = 0;
  // Longest part of a step along which the value stays finite; more than 1 where all of it may be
  // taken.
  virtual double largest_step(const BlockVector<W>& x, const BlockVector<W>& step) const {
    (void)x, (void)step;
    return std::numeric_limits<double>::infinity();
  }
};

template <int W>
using Terms = std::vector<std::unique_ptr<Term<W>>>;

}  // namespace curveups
