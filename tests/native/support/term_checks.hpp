// SPDX-License-Identifier: LGPL-2.1-or-later
// The one finite-difference test of every Term.
#pragma once

#include <gtest/gtest.h>

#include "curveups/numerics/term.hpp"

namespace curveups::test {

// How a term's second derivatives stand to its gradient.
enum class Curvature { exact, gauss_newton };

// Along random directions: the gradient against the value, values against one another, and second
// derivatives against the gradient (an approximation only has to be positive semidefinite).
// free: blocks of the matrix; the rows of all blocks are in the gradient.
template <int W>
void expect_derivatives(const Term<W>& term, const BlockVector<W>& x, const std::vector<char>& free,
                        Curvature curvature, double accuracy = 1e-6) {
  SCOPED_TRACE(std::string(term.name()));
  std::vector<Coupling> couplings(3, Coupling{0, 0});  // couplings of terms before this one
  const int first = static_cast<int>(couplings.size());
  term.couple(couplings);
  BlockMatrix<W> hessian(std::make_shared<const BlockPattern>(free, couplings));
  using Vector = BlockVector<W>;
  auto gradient_at = [&](const Vector& at, BlockMatrix<W>* matrix = nullptr) {
    Vector gradient = Vector::Zero(x.rows(), W);
    EXPECT_NEAR(term.derivatives(at, gradient, matrix, first), term.value(at),
                1e-12 * (1 + std::abs(term.value(at))));
    return gradient;
  };
  const Vector gradient = gradient_at(x, &hessian);
  EXPECT_GT(gradient.norm(), 0) << "constant: nothing was tested";
  const double h = 1e-5;
  for (int round = 0; round < 4; ++round) {
    Vector d = Vector::Random(x.rows(), W);
    const double difference = (term.value(x + h * d) - term.value(x - h * d)) / (2 * h);
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
