// SPDX-License-Identifier: LGPL-2.1-or-later
// Second-order cone programs over forces at points, three numbers each (normal n, two tangents t)
// with A f + b = 0 and the exact circular cone at every point:
//   floor:     maximise s   subject to  n >= s,      |t| <= mu n,              s <= 1;
//   relaxed:   the same with |t| <= mu (n - s), which always has a solution;
//   friction:  maximise s   subject to  n >= floor,  |t| <= mu n - s,         s <= 1.
// The interior-point method (cone_method.hpp) works on the normal equations A D A^T, with one
// factorization a step
// (L. Vandenberghe, "The CVXOPT linear and quadratic cone program solvers", 2010).
#pragma once

#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/core/types.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

// Linear map A of forces at points, and its normal equations.
class ForceMap {
 public:
  virtual ~ForceMap() = default;
  virtual int point_count() const = 0;
  virtual int rows() const = 0;
  virtual Eigen::VectorXd apply(const Eigen::VectorXd& f) const = 0;
  virtual Eigen::VectorXd apply_transposed(const Eigen::VectorXd& y) const = 0;
  // Factorizes A D A^T, D symmetric positive definite 3 x 3 per point; false where that fails.
  virtual bool factorize(const std::vector<Eigen::Matrix3d>& D) = 0;
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const = 0;
};

struct ConeOptions {
  double friction_coefficient = 0.5;  // mu
  bool relaxed = false;
  double tolerance = 1e-4;  // on s
  bool friction = false;    // the program of friction
  double floor = 0;         // with `friction`
};

struct ConeSolution {
  SolveReport solve;
  Eigen::VectorXd force;
  double s = 0;
  Eigen::VectorXd weight;  // dual weight of each point's cones
  Eigen::VectorXd y;       // multipliers of A f + b = 0
  Points3 circle;          // multipliers of the friction cones
  Eigen::VectorXd floor;   // multipliers of n >= s
};

// Forces in units in which s is at most 1. start: any forces. Leaves the map factorized for the
// last step. Throws Cancelled.
ConeSolution solve_cone_program(ForceMap& map, const Eigen::VectorXd& b,
                                const Eigen::VectorXd& start, const ConeOptions& options,
                                const Progress& progress);

}  // namespace curveups
