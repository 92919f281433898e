// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/anderson.hpp"

#include <Eigen/Cholesky>

namespace curveups {

Eigen::VectorXd AndersonIteration::next(const Eigen::VectorXd& guess,
                                        const Eigen::VectorXd& value) {
  constexpr std::size_t depth = 6;  // steps that are kept
  const Eigen::VectorXd error = value - guess;
  if (error_.size() == error.size()) {
    guess_steps_.push_back(guess - guess_);
    error_steps_.push_back(error - error_);
    if (guess_steps_.size() > depth) {
      guess_steps_.erase(guess_steps_.begin());
      error_steps_.erase(error_steps_.begin());
    }
  }
  guess_ = guess;
  error_ = error;
  const int n = static_cast<int>(error_steps_.size());
  Eigen::MatrixXd products(n, n);
  Eigen::VectorXd right(n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      products(i, j) = products(j, i) = error_steps_[i].dot(error_steps_[j]);
    }
    right(i) = error_steps_[i].dot(error);
  }
  // Steps that are nearly parallel say nothing of their difference.
  for (int i = 0; i < n; ++i) products(i, i) *= 1 + 1e-10;
  const Eigen::VectorXd share = products.ldlt().solve(right);
  Eigen::VectorXd out = value;
  if (!share.allFinite()) return out;
  for (int i = 0; i < n; ++i) out -= share(i) * (guess_steps_[i] + error_steps_[i]);
  return out;
}

}  // namespace curveups
