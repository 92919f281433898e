// SPDX-License-Identifier: LGPL-2.1-or-later
// Minimises the energies of Eq. 9 under hard constraints: a primal-dual interior-point method with
// slacks, condensed onto the Gauss-Newton pattern.
//
// Why a method of our own: least-squares solvers with bounds (Ceres) have no general inequality
// constraints, and Ipopt on the very same problem takes six to twelve times as long, because its
// linear algebra can't use that all blocks are 9 x 9 on one sparsity pattern that never changes.
// The energies and constraints are the BlockFunctions that the soft problem uses too.
//
//   minimise f(z) = 1/2 sum r(z)^2   subject to   c(z) - s = 0, s >= 0, lower <= q <= upper.
// With multipliers m of c, each step solves
//   (J_r^T J_r + J_c^T (m/s) J_c + bounds) dz = -grad f + J_c^T (mu/s - (m/s)(c - s)) + bounds,
// backtracks on the merit function f - mu sum log(slacks) + nu |c - s|_1, and is damped where that
// fails. The start need not be feasible.
#pragma once

#include "curveups/core/progress.hpp"
#include "curveups/layout/block_function.hpp"
#include "curveups/layout/normal_matrix.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

class InteriorPoint {
 public:
  // The model may gain gaps between runs; multipliers are kept.
  explicit InteriorPoint(const LayoutModel& model);

  // Improves `state` until complementarity mu_end is reached and the optimality conditions hold to
  // like accuracy, or max_iterations. The report has the largest violation of c(z) >= 0. progress
  // gets the share of the way from mu_start to mu_end.
  SolveReport run(LayoutState& state, double mu_start, double mu_end, int max_iterations,
                  const Progress& progress);

  // Drops slacks and multipliers: the next run starts afresh from its state.
  void forget();

 private:
  using Vectors = std::vector<Eigen::VectorXd>;  // one entry per block of each constraint function
  struct Linearization;
  struct Step;

  void prepare(LayoutState& state, double mu);
  void linearize(const LayoutState& state, Linearization& at) const;
  // False where multipliers have grown so far that no damping makes the matrix definite.
  bool solve_step(const LayoutState& state, double mu, Linearization& at, SparseCholesky& cholesky,
                  double& damping, Step& step) const;
  double merit(const LayoutState& state, const Vectors& slack, double mu, double penalty) const;
  double largest_violation(const LayoutState& state) const;

  const LayoutModel& model_;
  BlockFunctions energies_, constraints_;
  Vectors slack_, multiplier_;
  Array6 lower_multiplier_, upper_multiplier_;  // of the insets' bounds
};

}  // namespace curveups
