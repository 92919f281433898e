// SPDX-License-Identifier: LGPL-2.1-or-later
// Sparse Cholesky factorization of a symmetric positive definite matrix whose pattern stays while
// its values change: CHOLMOD, supernodal, on one thread. The only file that sees CHOLMOD.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace curveups {

// Only the lower triangle of the matrix is read.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

// Order of elimination with little fill (AMD, in postorder) for a graph: its k-th entry goes k-th.
// above[v] are the neighbours of v with higher numbers, ascending.
// Unknowns that come in blocks of one pattern are ordered many times faster by the graph of their
// blocks.
std::vector<int> elimination_order(const std::vector<std::vector<int>>& above);

enum class Ordering {
  by_fill,  // AMD, when the pattern is analyzed
  as_given  // the unknowns are numbered by an elimination_order already: no permuted copies
};

class SparseCholesky {
 public:
  explicit SparseCholesky(Ordering ordering = Ordering::by_fill);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  // Symbolic factorization. Throws SolverFailure when memory runs out.
  void analyze(const SparseMatrix& lower);
  // Order of elimination that the analysis chose.
  std::vector<int> order() const;
  // Numeric factorization of a matrix with the pattern last analyzed (analyzes when there is none).
  // Returns false when the matrix is not positive definite or holds a value that is not finite.
  bool factorize(const SparseMatrix& lower);
  // Solves A x = b for one or more right-hand sides with the last numeric factor.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  // Solves L x = b and L^T x = b with the factor, whose rows are in the order of elimination.
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace curveups
