// SPDX-License-Identifier: LGPL-2.1-or-later
// The subproblem of every repair step: the least step that keeps linearised constraints,
//   minimise 1/2 |z - wanted|^2 + price . e + 1/2 e . stiffness e
//   subject to   C z + c + e >= 0,  e >= 0,  lower <= z <= upper.
// Rows are sparse (layout constraints) or dense (normal forces: few, each of all unknowns). The
// elastic e makes every problem feasible: where constraints contradict one another the dearer ones
// win, and a row's e tells what is missing. A convex problem, solved by a primal-dual
// interior-point method; dense rows enter the sparse factorization by the Woodbury identity.
#pragma once

#include <Eigen/SparseCore>

#include "curveups/core/types.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

struct LeastStepProblem {
  SparseRows sparse;             // rows of C, sorted columns
  Eigen::VectorXd sparse_value;  // c
  Eigen::MatrixXd dense;         // one column per row of C
  Eigen::VectorXd dense_value;
  Eigen::VectorXd lower, upper;  // lower < upper, within which zero lies or on one of which
  Eigen::VectorXd wanted;        // empty for zero
  double sparse_price = 1e4, dense_price = 1e3;
  double dense_stiffness = 0;  // with a small price: dense rows as a quadratic penalty
};

struct LeastStep {
  Eigen::VectorXd z;
  // Multipliers: how much each constraint holds the step back; at its price where it is not met.
  Eigen::VectorXd sparse_multiplier, dense_multiplier, lower_multiplier, upper_multiplier;
  SolveReport solve;
};

// Throws SolverFailure where the problem holds numbers that are not finite.
LeastStep solve_least_step(const LeastStepProblem& problem);

}  // namespace curveups
