// SPDX-License-Identifier: LGPL-2.1-or-later
// Fixed points c = G(c) by Anderson's method (D. Anderson, Iterative procedures for nonlinear
// integral equations, 1965; H. Walker, P. Ni, Anderson acceleration for fixed-point iterations,
// 2011): the next guess comes from the combination of the last ones whose error is least.
// Iterations that would swing or run away along a few directions converge.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace curveups {

class AndersonIteration {
 public:
  // The next guess after G(guess) = value.
  Eigen::VectorXd next(const Eigen::VectorXd& guess, const Eigen::VectorXd& value);

 private:
  Eigen::VectorXd guess_, error_;
  std::vector<Eigen::VectorXd> guess_steps_, error_steps_;  // the last ones
};

}  // namespace curveups
