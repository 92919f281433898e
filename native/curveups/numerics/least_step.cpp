// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/least_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/numerics/block_matrix.hpp"

namespace curveups {
namespace {

constexpr int max_iterations = 80;

using Eigen::ArrayXd;
using Eigen::VectorXd;

// C^T W C + diagonal over the sparse rows: a coupling for every product of two entries of a row.
template <class Body>
void for_products(const SparseRows& rows, const Body& body) {
  for (int r = 0; r < rows.rows(); ++r) {
    for (SparseRows::InnerIterator a(rows, r); a; ++a) {
      for (SparseRows::InnerIterator b(rows, r); b && b.col() <= a.col(); ++b) body(r, a, b);
    }
  }
}

std::shared_ptr<const BlockPattern> normal_pattern(const SparseRows& rows) {
  std::vector<Coupling> couplings;
  for_products(rows, [&](int, const auto& a, const auto& b) {
    couplings.push_back({static_cast<int>(a.col()), static_cast<int>(b.col())});
  });
  return std::make_shared<const BlockPattern>(std::vector<char>(rows.cols(), 1), couplings);
}

void assemble(const SparseRows& rows, const ArrayXd& weight, const ArrayXd& diagonal,
              BlockMatrix<1>& normal) {
  normal.set_zero();
  for (int j = 0; j < diagonal.size(); ++j) normal.diagonal(j, 0) = diagonal(j);
  int coupling = 0;
  for_products(rows, [&](int r, const auto& a, const auto& b) {
    const double scaled = weight(r) * a.value();
    *normal.column(normal.pattern().slot(coupling++), 0) += scaled * b.value();
  });
}

// All rows, sparse ones first.
VectorXd rows_times(const LeastStepProblem& p, const VectorXd& z) {
  VectorXd out(p.sparse.rows() + p.dense.cols());
  out.head(p.sparse.rows()) = p.sparse * z;
  out.tail(p.dense.cols()) = p.dense.transpose() * z;
  return out;
}

VectorXd transposed_times(const LeastStepProblem& p, const VectorXd& m) {
  return p.sparse.transpose() * m.head(p.sparse.rows()) + p.dense * m.tail(p.dense.cols());
}

// The largest step (at most 1) that keeps value + step change positive by 0.5 %.
double step_length(const ArrayXd& value, const ArrayXd& change) {
  double length = 1;
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    if (change(i) < 0) length = std::min(length, -0.995 * value(i) / change(i));
  }
  return length;
}

// Iterates: z, the rows' slacks s and elastic parts e, and multipliers of s, e and the bounds.
class LeastStepMethod {
 public:
  explicit LeastStepMethod(const LeastStepProblem& problem);
  LeastStep run();

 private:
  struct Direction {
    ArrayXd z, s, e, m, elastic, lower, upper;
  };
  void linearize();
  bool converged() const;
  // False where the matrix can't be factorized.
  bool newton(Direction& d);
  void advance(const Direction& d);

  const LeastStepProblem& problem_;
  const Eigen::Index n_, sparse_, dense_, rows_;
  VectorXd c_, wanted_;
  ArrayXd penalty_;
  BlockMatrix<1> normal_;
  ArrayXd z_, s_, e_;
  // elastic_, of e, is kept apart from penalty - m, which cancels where a row stays unmet.
  ArrayXd m_, elastic_, lower_, upper_;
  ArrayXd low_, high_, residual_, dual_, unpaid_;  // at the iterate; rooms first
  double mu_ = 1e-2;
};

LeastStepMethod::LeastStepMethod(const LeastStepProblem& problem)
    : problem_(problem),
      n_(problem.lower.size()),
      sparse_(problem.sparse.rows()),
      dense_(problem.dense.cols()),
      rows_(sparse_ + dense_),
      c_(rows_),
      wanted_(problem.wanted.size() > 0 ? problem.wanted : VectorXd::Zero(n_)),
      penalty_(rows_),
      normal_(normal_pattern(problem.sparse)) {
  c_.head(sparse_) = problem.sparse_value;
  c_.tail(dense_) = problem.dense_value;
  penalty_.head(sparse_) = problem.sparse_penalty;
  penalty_.tail(dense_) = problem.dense_penalty;
  const ArrayXd width = (problem.upper - problem.lower).array();
  z_ = (-problem.lower.array()).max(0.1 * width).min(0.9 * width) + problem.lower.array();
  // On the central path of complementarity mu as nearly as z allows.
  const ArrayXd at_start = rows_times(problem, z_.matrix()).array() + c_.array();
  s_ = at_start.max(0.1);
  e_ = (s_ - at_start).max(1e-3);
  m_ = (mu_ / s_).min(0.5 * penalty_);
  elastic_ = penalty_ - m_;
  lower_ = mu_ / (z_ - problem.lower.array());
  upper_ = mu_ / (problem.upper.array() - z_);
}

void LeastStepMethod::linearize() {
  low_ = z_ - problem_.lower.array();
  high_ = problem_.upper.array() - z_;
  residual_ = rows_times(problem_, z_.matrix()).array() + c_.array() + e_ - s_;
  dual_ = z_ - wanted_.array() - transposed_times(problem_, m_.matrix()).array() - lower_ + upper_;
  unpaid_ = penalty_ - m_ - elastic_;
  const double products =
      (s_ * m_).sum() + (e_ * elastic_).sum() + (low_ * lower_).sum() + (high_ * upper_).sum();
  mu_ = products / static_cast<double>(2 * rows_ + 2 * n_);
  if (!std::isfinite(mu_)) {
    throw SolverFailure("a repair step holds numbers that are not finite",
                        "check the design for degenerate tiles");
  }
}

bool LeastStepMethod::converged() const {
  const double infeasible = rows_ > 0 ? residual_.abs().maxCoeff() : 0.0;
  const double unpaid = rows_ > 0 ? unpaid_.abs().maxCoeff() : 0.0;
  return mu_ < 1e-10 && infeasible < 1e-9 &&
         std::max(dual_.abs().maxCoeff(), unpaid / (1 + problem_.sparse_penalty)) < 1e-6;
}

bool LeastStepMethod::newton(Direction& d) {
  const double target = 0.15 * mu_;
  const ArrayXd weight = 1 / (s_ / m_ + e_ / elastic_);
  const ArrayXd free = (target - e_ * (elastic_ + unpaid_)) / elastic_;
  const ArrayXd k = -residual_ - free + target / m_ - s_;
  const VectorXd right = wanted_ - z_.matrix() +
                         transposed_times(problem_, (m_ + weight * k).matrix()) +
                         (target / low_ - target / high_).matrix();
  assemble(problem_.sparse, weight.head(sparse_), 1 + lower_ / low_ + upper_ / high_, normal_);
  if (!normal_.factorize()) return false;
  Eigen::MatrixXd sides(n_, 1 + dense_);
  sides.col(0) = right;
  sides.rightCols(dense_) = problem_.dense;
  const Eigen::MatrixXd solved = normal_.solve(sides);
  VectorXd dz = solved.col(0);
  if (dense_ > 0) {
    const auto response = solved.rightCols(dense_);
    Eigen::MatrixXd small = problem_.dense.transpose() * response;
    small.diagonal() += (1 / weight.tail(dense_)).matrix();
    dz -= response * small.ldlt().solve(problem_.dense.transpose() * dz);
  }
  if (!dz.allFinite()) return false;
  d.z = dz.array();
  d.m = weight * (k - rows_times(problem_, dz).array());
  d.e = free + e_ / elastic_ * d.m;
  d.elastic = unpaid_ - d.m;
  d.s = target / m_ - s_ - s_ / m_ * d.m;
  d.lower = target / low_ - lower_ - lower_ / low_ * d.z;
  d.upper = target / high_ - upper_ + upper_ / high_ * d.z;
  return true;
}

void LeastStepMethod::advance(const Direction& d) {
  const double primal = std::min({step_length(s_, d.s), step_length(e_, d.e),
                                  step_length(low_, d.z), step_length(high_, -d.z)});
  const double dual = std::min({step_length(m_, d.m), step_length(elastic_, d.elastic),
                                step_length(lower_, d.lower), step_length(upper_, d.upper)});
  z_ += primal * d.z;
  s_ += primal * d.s;
  e_ += primal * d.e;
  m_ += dual * d.m;
  elastic_ += dual * d.elastic;
  lower_ += dual * d.lower;
  upper_ += dual * d.upper;
}

LeastStep LeastStepMethod::run() {
  LeastStep out;
  Direction d;
  for (; out.solve.iterations < max_iterations; ++out.solve.iterations) {
    linearize();
    if (converged()) {
      out.solve.status = SolveStatus::converged;
      break;
    }
    if (!newton(d)) break;
    advance(d);
  }
  out.z = z_;
  out.sparse_multiplier = m_.head(sparse_);
  out.dense_multiplier = m_.tail(dense_);
  out.lower_multiplier = lower_;
  out.upper_multiplier = upper_;
  return out;
}

}  // namespace

LeastStep solve_least_step(const LeastStepProblem& problem) {
  return LeastStepMethod(problem).run();
}

}  // namespace curveups
