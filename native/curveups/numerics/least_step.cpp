// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/least_step.hpp"

#include <cblas.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/numerics/block_matrix.hpp"
#include "curveups/numerics/one_thread.hpp"

namespace curveups {
namespace {

constexpr int max_iterations = 80;
// By how much of a change of its multiplier a row may be missed in one iteration: the next ones
// make up for it. Without, a met row's weight grows until rounding of its value outweighs the
// multiplier.
constexpr double least_give = 1e-11;
// Iterations of conjugate gradients, and their residual relative to the first, in the
// preconditioner's norm.
constexpr int most_krylov_iterations = 200;
constexpr double krylov_tolerance = 1e-2;

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

// The largest step that keeps value + step change from getting negative.
double longest(const ArrayXd& value, const ArrayXd& change) {
  double length = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    if (change(i) < 0) length = std::min(length, -value(i) / change(i));
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
  // What products of complementary values are to become.
  struct Products {
    ArrayXd s, e, lower, upper;
  };
  VectorXd gradient() const;
  void linearize();
  bool converged() const;
  // The Newton system's matrix at the iterate. False where it can't be.
  bool factorize();
  VectorXd solve(const VectorXd& right) const;
  VectorXd solve_rows(const VectorXd& right) const;
  VectorXd multiply_rows(const VectorXd& z) const;
  Direction newton(const Products& target) const;
  double step_length(const Direction& d) const;
  // Products mu, less the second-order terms of the step that leads to none.
  static Products corrected(double mu, const Direction& affine);
  // Of the iterate after a step of this length, summed up.
  double complementarity(const Direction& d, double length) const;
  void advance(const Direction& d, double length);

  const LeastStepProblem& problem_;
  const Eigen::Index n_, sparse_, dense_, rows_;
  VectorXd c_, wanted_;
  ArrayXd penalty_;
  BlockMatrix<1> normal_;
  // Of the Newton system: weights of the rows; dense rows, also by L^-1 of the sparse rows' L L^T;
  // what the Woodbury identity leaves of them.
  ArrayXd weight_;
  Eigen::MatrixXd dense_ranked_, half_;
  Eigen::LDLT<Eigen::MatrixXd> small_;
  ArrayXd z_, s_, e_;
  // elastic_, of e, is kept apart from penalty - m, which cancels where a row stays unmet.
  ArrayXd m_, elastic_, lower_, upper_;
  ArrayXd low_, high_;  // rooms to the bounds, kept apart from z: it has no digits for small ones
  ArrayXd residual_, dual_, unpaid_;
  double mu_ = LeastStepProblem::dense_penalty;  // at first: of several tried with the fewest steps
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
      normal_(normal_pattern(problem.sparse)),
      dense_ranked_(normal_.ranked(problem.dense)) {
  c_.head(sparse_) = problem.sparse_value;
  c_.tail(dense_) = problem.dense_value;
  penalty_.head(sparse_) = problem.sparse_penalty;
  penalty_.tail(dense_) = problem.dense_penalty;
  const ArrayXd width = (problem.upper - problem.lower).array();
  z_ = (-problem.lower.array()).max(0.1 * width).min(0.9 * width) + problem.lower.array();
  // On the central path of complementarity mu, but for z: s m = mu, e (penalty - m) = mu.
  const ArrayXd u = (rows_times(problem, z_.matrix()) + c_).array() * penalty_ / (2 * mu_);
  const ArrayXd root = (1 + u.square()).sqrt();
  const ArrayXd ratio = (u > 0).select(u + root, 1 / (root - u));  // of elastic_ to m_
  m_ = penalty_ / (1 + ratio);
  elastic_ = m_ * ratio;
  s_ = mu_ / m_;
  e_ = mu_ / elastic_;
  low_ = z_ - problem.lower.array();
  high_ = problem.upper.array() - z_;
  lower_ = mu_ / low_;
  upper_ = mu_ / high_;
}

// Of the objective, but for the elastic parts.
VectorXd LeastStepMethod::gradient() const {
  VectorXd out = z_.matrix() - wanted_;
  if (problem_.quadratic) out += problem_.quadratic->apply(z_.matrix()) + problem_.linear;
  return out;
}

void LeastStepMethod::linearize() {
  residual_ = rows_times(problem_, z_.matrix()).array() + c_.array() + e_ - s_;
  dual_ = gradient().array() - transposed_times(problem_, m_.matrix()).array() - lower_ + upper_;
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
  const double dual = std::max(dual_.abs().maxCoeff(), unpaid / (1 + problem_.sparse_penalty));
  // Conjugate gradients leave a dual residual.
  if (problem_.quadratic) return mu_ < 1e-4 && infeasible < 1e-6 && dual < 1e-2;
  return mu_ < 1e-10 && infeasible < 1e-9 && dual < 1e-6;
}

bool LeastStepMethod::factorize() {
  weight_ = 1 / (s_ / m_ + e_ / elastic_ + least_give);
  assemble(problem_.sparse, weight_.head(sparse_), 1 + lower_ / low_ + upper_ / high_, normal_);
  if (!normal_.factorize()) return false;
  if (dense_ > 0) {
    half_ = normal_.factor().solve_lower(dense_ranked_);
    Eigen::MatrixXd small = Eigen::MatrixXd((1 / weight_.tail(dense_)).matrix().asDiagonal());
    const OneThread guard;
    cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, static_cast<int>(dense_),
                static_cast<int>(n_), 1, half_.data(), static_cast<int>(n_), 1, small.data(),
                static_cast<int>(dense_));
    small_.compute(small);
  }
  return true;
}

// Of all but the quadratic map.
VectorXd LeastStepMethod::solve_rows(const VectorXd& right) const {
  VectorXd z = normal_.factor().solve_lower(normal_.ranked(right));
  if (dense_ > 0) z -= half_ * small_.solve(half_.transpose() * z);
  return normal_.unranked(normal_.factor().solve_upper(z));
}

VectorXd LeastStepMethod::multiply_rows(const VectorXd& z) const {
  VectorXd out = normal_.multiply(z);
  if (dense_ > 0) {
    out +=
        problem_.dense * weight_.tail(dense_).matrix().cwiseProduct(problem_.dense.transpose() * z);
  }
  return out;
}

// With what rounding left of the right-hand side once more; by conjugate gradients where there is a
// quadratic map, preconditioned by all the rest.
VectorXd LeastStepMethod::solve(const VectorXd& right) const {
  VectorXd z = solve_rows(right);
  if (!problem_.quadratic) return z + solve_rows(right - multiply_rows(z));
  VectorXd p = z, r = right, y = z;
  z.setZero();
  double now = r.dot(y);
  const double enough = krylov_tolerance * krylov_tolerance * now;
  for (int k = 0; k < most_krylov_iterations && now > enough; ++k) {
    const VectorXd along = multiply_rows(p) + problem_.quadratic->apply(p);
    const double length = now / p.dot(along);
    z += length * p;
    r -= length * along;
    y = solve_rows(r);
    const double next = r.dot(y);
    checkpoint();
    p = y + next / now * p;
    now = next;
  }
  return z;
}

LeastStepMethod::Direction LeastStepMethod::newton(const Products& target) const {
  const ArrayXd free = (target.e - e_ * (elastic_ + unpaid_)) / elastic_;
  const ArrayXd k = -residual_ - free + target.s / m_ - s_;
  const VectorXd right = -gradient() + transposed_times(problem_, (m_ + weight_ * k).matrix()) +
                         (target.lower / low_ - target.upper / high_).matrix();
  const VectorXd dz = solve(right);
  Direction d;
  d.z = dz.array();
  d.m = weight_ * (k - rows_times(problem_, dz).array());
  d.e = free + e_ / elastic_ * d.m;
  d.elastic = unpaid_ - d.m;
  d.s = target.s / m_ - s_ - s_ / m_ * d.m;
  d.lower = target.lower / low_ - lower_ - lower_ / low_ * d.z;
  d.upper = target.upper / high_ - upper_ + upper_ / high_ * d.z;
  return d;
}

double LeastStepMethod::step_length(const Direction& d) const {
  return std::min({longest(s_, d.s), longest(e_, d.e), longest(low_, d.z), longest(high_, -d.z),
                   longest(m_, d.m), longest(elastic_, d.elastic), longest(lower_, d.lower),
                   longest(upper_, d.upper)});
}

double LeastStepMethod::complementarity(const Direction& d, double t) const {
  return ((s_ + t * d.s) * (m_ + t * d.m)).sum() +
         ((e_ + t * d.e) * (elastic_ + t * d.elastic)).sum() +
         ((low_ + t * d.z) * (lower_ + t * d.lower)).sum() +
         ((high_ - t * d.z) * (upper_ + t * d.upper)).sum();
}

LeastStepMethod::Products LeastStepMethod::corrected(double mu, const Direction& affine) {
  return {mu - affine.s * affine.m, mu - affine.e * affine.elastic, mu - affine.z * affine.lower,
          mu + affine.z * affine.upper};
}

void LeastStepMethod::advance(const Direction& d, double length) {
  z_ += length * d.z;
  low_ += length * d.z;
  high_ -= length * d.z;
  s_ += length * d.s;
  e_ += length * d.e;
  m_ += length * d.m;
  elastic_ += length * d.elastic;
  lower_ += length * d.lower;
  upper_ += length * d.upper;
}

LeastStep LeastStepMethod::run() {
  LeastStep out;
  const Products none{ArrayXd::Zero(rows_), ArrayXd::Zero(rows_), ArrayXd::Zero(n_),
                      ArrayXd::Zero(n_)};
  for (; out.solve.iterations < max_iterations; ++out.solve.iterations) {
    linearize();
    if (converged()) {
      out.solve.status = SolveStatus::converged;
      break;
    }
    if (!factorize()) break;
    const Direction affine = newton(none);
    const double left = std::min(1.0, complementarity(affine, std::min(1.0, step_length(affine))) /
                                          complementarity(affine, 0));
    const Direction way = newton(corrected(left * left * left * mu_, affine));
    if (!way.z.allFinite()) break;
    advance(way, std::min(1.0, 0.995 * step_length(way)));
  }
  out.z = z_.max(problem_.lower.array()).min(problem_.upper.array());
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
