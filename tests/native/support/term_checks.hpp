// SPDX-License-Identifier: LGPL-2.1-or-later
// Finite-difference test of energies.
#pragma once

#include <gtest/gtest.h>

#include "curveups/numerics/block_matrix.hpp"

namespace curveups::test {

// How an energy's second derivatives stand to its gradient.
enum class Curvature { exact, gauss_newton };

// Along random directions: the gradient against the value, values against one another, and second
// derivatives against the gradient (an approximation only has to be positive semidefinite).
// free: blocks of the matrix; the rows of all blocks are in the gradient.
template <class Energy, class Vector>
void expect_derivatives(const Energy& energy, const Vector& x, const std::vector<char>& free,
                        Curvature curvature, double accuracy = 1e-6) {
  constexpr int W = Vector::ColsAtCompileTime;
  std::vector<Coupling> couplings(3, Coupling{0, 0});  // couplings of energies before this one
  const int first = static_cast<int>(couplings.size());
  energy.couple(couplings);
  BlockMatrix<W> hessian(std::make_shared<const BlockPattern>(free, couplings));
  auto gradient_at = [&](const Vector& at, BlockMatrix<W>* matrix = nullptr) {
    Vector gradient = Vector::Zero(x.rows(), W);
    EXPECT_NEAR(energy.derivatives(at, gradient, matrix, first), energy.value(at),
                1e-12 * (1 + std::abs(energy.value(at))));
    return gradient;
  };
  const Vector gradient = gradient_at(x, &hessian);
  EXPECT_GT(gradient.norm(), 0) << "constant: nothing was tested";
  const double h = 1e-5;
  for (int round = 0; round < 4; ++round) {
    Vector d = Vector::Random(x.rows(), W);
    const double difference = (energy.value(x + h * d) - energy.value(x - h * d)) / (2 * h);
    EXPECT_NEAR(gradient.cwiseProduct(d).sum(), difference, accuracy * gradient.norm() * d.norm());
    for (int b = 0; b < d.rows(); ++b) {
      if (!free[b]) d.row(b).setZero();
    }
    const Eigen::MatrixXd product =
        hessian.multiply(Eigen::Map<const Eigen::VectorXd>(d.data(), d.size()));
    const Eigen::Map<const Vector> along(product.data(), d.rows(), W);
    if (curvature == Curvature::gauss_newton) {
      EXPECT_GE(along.cwiseProduct(d).sum(), 0);
      continue;
    }
    Vector expected = (gradient_at(x + h * d) - gradient_at(x - h * d)) / (2 * h);
    for (int b = 0; b < d.rows(); ++b) {
      if (!free[b]) expected.row(b).setZero();
    }
    EXPECT_LT((along - expected).norm(), accuracy * (1 + expected.norm()));
  }
}

}  // namespace curveups::test
