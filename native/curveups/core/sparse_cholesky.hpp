// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse Cholesky factorization of a symmetric positive definite matrix whose pattern stays while
// its values change: CHOLMOD, supernodal, on one BLAS thread. The only file that sees CHOLMOD.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace curveups {

// Only the lower triangle of the matrix is read.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

class SparseCholesky {
 public:
  SparseCholesky();
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  // Symbolic factorization (AMD ordering). Throws SolverFailure when memory runs out.
  void analyze(const SparseMatrix& lower);
  // Numeric factorization of a matrix with the pattern last analyzed (analyzes when there is none).
  // Returns false when the matrix is not positive definite or holds a value that is not finite.
  bool factorize(const SparseMatrix& lower);
  // Solves A x = b for one or more right-hand sides with the last numeric factor.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace curveups
