// SPDX-License-Identifier: LGPL-2.1-or-later
// Minimises energies under inequality constraints: a primal-dual interior-point method with
// slacks, condensed onto the pattern of the terms.
//
// Least-squares solvers with bounds have no general inequality constraints, and Ipopt takes six to
// twelve times as long on the same problem: its linear algebra can't use that all blocks are alike
// on a constant pattern.
//
//   minimise f(z)   subject to   c(z) - s = 0, s >= 0, lower <= z <= upper for some unknowns.
// With multipliers m of c, each step solves
//   (H + J^T (m/s) J + bounds) dz = -grad f + J^T (mu/s - (m/s)(c - s)) + bounds,
// H and J the terms' and constraints' derivatives, backtracks on the merit function
// f - mu sum log(slacks) + nu |c - s|_1, and is damped where that fails. The start need not be
// feasible.
#pragma once

#include <functional>
#include <limits>

#include "curveups/core/progress.hpp"
#include "curveups/numerics/residuals.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

// lower < upper, both finite.
struct Bound {
  int block, unknown;
  double lower, upper;
};

// Complementarity where a run begins and where it ends, and the largest violation of a constraint
// at its end: complementarity has another unit, and bounds violations only roughly.
struct Levels {
  double mu_start, mu_end;
  double violation = std::numeric_limits<double>::infinity();
};

class InteriorPoint {
 public:
  using Vector = Residuals::Vector;

  // constraints: each with a row an element.
  InteriorPoint(ResidualsList energies, ResidualsList constraints, std::vector<Bound> bounds)
      : energies_(std::move(energies)),
        constraints_(std::move(constraints)),
        bounds_(std::move(bounds)) {}

  // Called after each barrier level mu. May append elements to constraints; returns true if it did.
  // The run goes on with all slacks and multipliers.
  using Discover = std::function<bool(const Vector& z, double mu)>;

  // Improves z, from fresh slacks and multipliers, until complementarity mu_end is reached, the
  // optimality conditions hold to like accuracy, no constraint is violated too far and nothing more
  // is discovered, or for max_iterations. progress gets `what` and the share of the way from
  // mu_start to mu_end. Stopped within an iteration, z stays as before it. The report's residual is
  // the largest violation of c(z) >= 0.
  SolveReport run(Vector& z, const Levels& levels, int max_iterations, const std::string& what,
                  const Progress& progress, const Discover& discover = {});

 private:
  using Vectors = std::vector<Eigen::VectorXd>;  // per constraint, entry an element
  struct Linearization;
  struct Step;

  void iterate(Vector& z, const Levels& levels, int max_iterations, const std::string& what,
               const Progress& progress, const Discover& discover, SolveReport& report);
  void begin(Vector& z, double mu);
  void take_new_constraints(const Vector& z, double mu);
  void linearize(const Vector& z, Linearization& at) const;
  void linearize_constraints(const Vector& z, Linearization& at) const;
  void linearize_bounds(const Vector& z, Linearization& at) const;
  Vector right_side(const Vector& z, double mu, const Linearization& at) const;
  // False where multipliers have grown so far that no damping makes the matrix definite.
  bool solve_step(const Vector& z, double mu, Linearization& at, double& damping, Step& step) const;
  void step_slacks(double mu, const Linearization& at, Step& step) const;
  void step_bounds(const Vector& z, double mu, Step& step) const;
  double merit(const Vector& z, const Vectors& slack, double mu, double penalty) const;
  // Backtracks; false where no length is good enough.
  bool search(Vector& z, double mu, double penalty, double residual_sum, const Step& step,
              double& length);

  ResidualsList energies_, constraints_;
  std::vector<Bound> bounds_;
  Vectors slack_, multiplier_;
  Eigen::VectorXd lower_multiplier_, upper_multiplier_;  // per bound
};

}  // namespace curveups
