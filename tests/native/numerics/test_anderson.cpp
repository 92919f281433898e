// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "curveups/numerics/anderson.hpp"

namespace curveups {
namespace {

TEST(Anderson, ConvergesWhereTheIterationAloneRunsAway) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(30, 30);
  for (int i = 0; i < 30; ++i) A(i, i) = 0.01 * i;
  A(3, 3) = -1.4;  // swings and grows
  A(4, 4) = 2.5;   // runs away
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(30);
  const Eigen::VectorXd answer =
      (Eigen::MatrixXd::Identity(30, 30) - A).colPivHouseholderQr().solve(b);
  Eigen::VectorXd alone = Eigen::VectorXd::Zero(30), c = alone;
  AndersonIteration iteration;
  for (int k = 0; k < 40; ++k) {
    alone = A * alone + b;
    c = iteration.next(c, A * c + b);
  }
  EXPECT_GT((alone - answer).norm(), 1e3);
  EXPECT_LT((c - answer).norm(), 1e-8);
}

}  // namespace
}  // namespace curveups
