// SPDX-License-Identifier: LGPL-2.1-or-later
// Least step that keeps linearised constraints, a convex quadratic program:
//   minimise 1/2 |z - wanted|^2 + 1/2 z . Q z + linear . z + penalty . e
//   subject to   C z + c + e >= 0,  e >= 0,  lower <= z <= upper.
// Rows are sparse (geometric constraints) or dense (few, each of all unknowns). The elastic e makes
// every problem feasible (exact penalty): where constraints contradict one another those of the
// larger penalty win, and a row's e is its violation. The interior-point method (cone_method.hpp)
// is regularized (M. Friedlander, D. Orban, A primal-dual regularized interior-point method for
// convex quadratic programs, 2012); dense rows enter the sparse factorization by the Woodbury
// identity.
#pragma once

#include <Eigen/SparseCore>
#include <functional>

#include "curveups/core/types.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

struct LeastStepProblem {
  SparseRows sparse;             // rows of C, sorted columns
  Eigen::VectorXd sparse_value;  // c
  Eigen::MatrixXd dense;         // column per row of C
  Eigen::VectorXd dense_value;
  Eigen::VectorXd lower, upper;  // lower < upper, within which zero lies or on one of which
  Eigen::VectorXd wanted;        // empty for zero
  // Q z, Q symmetric and positive semi-definite; empty for zero.
  std::function<Eigen::VectorXd(const Eigen::VectorXd& z)> quadratic;
  Eigen::VectorXd linear;  // with `quadratic`
  static constexpr double sparse_penalty = 1e4, dense_penalty = 1e3;
};

struct LeastStep {
  Eigen::VectorXd z;
  // Multipliers of the constraints; at its penalty where a row is not met.
  Eigen::VectorXd sparse_multiplier, dense_multiplier, lower_multiplier, upper_multiplier;
  SolveReport solve;
};

// Throws SolverFailure where the problem holds numbers that are not finite; Cancelled.
LeastStep solve_least_step(const LeastStepProblem& problem);

}  // namespace curveups
