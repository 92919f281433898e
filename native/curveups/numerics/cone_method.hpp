// SPDX-License-Identifier: LGPL-2.1-or-later
// Interior-point method for linear and convex quadratic programs whose slacks z lie in a product of
// half-lines and second-order cones |(u1, u2)| <= u0, with multipliers l in the same product:
// Mehrotra's predictor-corrector with Nesterov-Todd scaling W l = W^-1 z (L. Vandenberghe, "The
// CVXOPT linear and quadratic cone program solvers", 2010). A problem computes its residuals and
// solves its Newton system; the method handles the cones.
#pragma once

#include <vector>

#include "curveups/core/types.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

// Point of the product of cones, or direction in it.
struct ConePoint {
  Eigen::ArrayXd line;           // coordinates on half-lines
  Points3 cone = Points3(0, 3);  // row per second-order cone
};

struct ConeStep {
  ConePoint slack, multiplier;
};

// Scaling of one second-order cone: W symmetric with W l = W^-1 z = nu.
struct ConeScaling {
  Eigen::Matrix3d W, W_inverse, W_squared;
  // Inverse of the tangential 2 x 2 block of W^-2, for which W^-2 itself has too few digits.
  Eigen::Matrix2d tangential;
  Vec3 nu;
};
ConeScaling cone_scaling(const Vec3& z, const Vec3& l);

// Largest step in [0, limit] that keeps u + step d in the second-order cone; u inside.
double cone_step(const Vec3& u, const Vec3& d, double limit);

class ConeProblem {
 public:
  virtual ~ConeProblem() = default;
  // Computes the residuals of the iterate; true where these and the complementarity z . l are small
  // enough.
  virtual bool converged(double complementarity) = 0;
  // Factorizes the Newton system at the iterate; false where that fails.
  virtual bool factorize(const std::vector<ConeScaling>& scalings) = 0;
  // Direction dx that leaves no residuals, to first order, with dz + W^2 dl = shift; returns dz and
  // dl. On half-lines W^2 = z / l.
  virtual ConeStep newton(const ConePoint& shift) = 0;
  // Moves x along the last direction.
  virtual void advance(double length) = 0;

  ConePoint slack, multiplier;  // z and l, strictly inside at the start
};

// Improves the problem's iterate until it has converged. Unfinished where the iterations run out, a
// factorization fails, or steps become too short.
SolveReport solve_cone_problem(ConeProblem& problem, int max_iterations);

}  // namespace curveups
