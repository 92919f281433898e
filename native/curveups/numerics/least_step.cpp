// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/least_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/numerics/block_matrix.hpp"
#include "curveups/numerics/cone_method.hpp"

// NOLINTNEXTLINE(readability-identifier-naming): the name of BLAS.
extern "C" void dsyrk_(const char* half, const char* side, const int* size, const int* rank,
                       const double* alpha, const double* a, const int* a_stride,
                       const double* beta, double* c, const int* c_stride);

namespace curveups {
namespace {

constexpr int max_iterations = 80;
// Regularization: part of a change of its multiplier by which a row may be missed in an iteration;
// later ones make up for it. Without it, a met row's weight grows until rounding of its value
// outweighs the multiplier.
constexpr double least_give = 1e-11;
// Iterations of conjugate gradients, and their residual relative to the first, in the
// preconditioner's norm.
constexpr int most_krylov_iterations = 200;
constexpr double krylov_tolerance = 1e-2;

using Eigen::ArrayXd;
using Eigen::VectorXd;

// Calls body for every product of two entries of a row, each of which is a coupling of C^T W C.
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

// Product of z with all rows, sparse ones first.
VectorXd rows_times(const LeastStepProblem& p, const VectorXd& z) {
  VectorXd out(p.sparse.rows() + p.dense.cols());
  out.head(p.sparse.rows()) = p.sparse * z;
  out.tail(p.dense.cols()) = p.dense.transpose() * z;
  return out;
}

VectorXd transposed_times(const LeastStepProblem& p, const VectorXd& m) {
  return p.sparse.transpose() * m.head(p.sparse.rows()) + p.dense * m.tail(p.dense.cols());
}

// Iterate z with the half-lines of a ConeProblem, one after another: slacks s of the rows with
// multipliers m; elastic parts e; rooms from the lower and to the upper bounds. These rooms are
// kept apart from z, which has no digits for small ones, and the multipliers of e apart from
// penalty - m, which cancels where a row stays unmet.
class LeastStepMethod : public ConeProblem {
 public:
  explicit LeastStepMethod(const LeastStepProblem& problem);
  LeastStep run();

  bool converged(double complementarity) override;
  bool factorize(const std::vector<ConeScaling>& scalings) override;
  ConeStep newton(const ConePoint& shift) override;
  void advance(double length) override { z_ += length * dz_; }

 private:
  struct Parts {
    ArrayXd s, e, low, high;
  };
  Parts parts(const ArrayXd& line) const {
    return {line.head(rows_), line.segment(rows_, rows_), line.segment(2 * rows_, n_),
            line.tail(n_)};
  }
  ArrayXd joined(const Parts& parts) const {
    ArrayXd out(2 * (rows_ + n_));
    out << parts.s, parts.e, parts.low, parts.high;
    return out;
  }
  VectorXd gradient() const;
  VectorXd solve(const VectorXd& right) const;
  VectorXd solve_rows(const VectorXd& right) const;
  VectorXd multiply_rows(const VectorXd& z) const;

  const LeastStepProblem& problem_;
  const Eigen::Index n_, sparse_, dense_, rows_;
  VectorXd c_, wanted_;
  ArrayXd penalty_, z_, dz_;
  BlockMatrix<1> normal_;
  // Newton system: weights of the rows and z / l of the half-lines; dense rows, also by L^-1 of the
  // sparse rows' L L^T; Schur complement that the Woodbury identity leaves of them.
  ArrayXd weight_;
  Parts scale_;
  Eigen::MatrixXd dense_ranked_, half_;
  Eigen::LDLT<Eigen::MatrixXd> small_;
  // Residuals: of the rows, of the objective's gradient, of the elastic parts' multipliers.
  ArrayXd residual_, dual_, unpaid_;
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
  c_ << problem.sparse_value, problem.dense_value;
  penalty_.head(sparse_) = problem.sparse_penalty;
  penalty_.tail(dense_) = problem.dense_penalty;
  const ArrayXd width = (problem.upper - problem.lower).array();
  z_ = (-problem.lower.array()).max(0.1 * width).min(0.9 * width) + problem.lower.array();
  // On the central path of this complementarity, but for z: s m = mu, e (penalty - m) = mu.
  constexpr double mu = LeastStepProblem::dense_penalty;  // of several tried with the fewest steps
  const ArrayXd u = (rows_times(problem, z_.matrix()) + c_).array() * penalty_ / (2 * mu);
  const ArrayXd root = (1 + u.square()).sqrt();
  const ArrayXd ratio = (u > 0).select(u + root, 1 / (root - u));  // ratio of e's multipliers to m
  const ArrayXd m = penalty_ / (1 + ratio);
  multiplier.line =
      joined({m, m * ratio, mu / (z_ - problem.lower.array()), mu / (problem.upper.array() - z_)});
  slack.line = mu / multiplier.line;
}

// Gradient of the objective without the elastic parts.
VectorXd LeastStepMethod::gradient() const {
  VectorXd out = z_.matrix() - wanted_;
  if (problem_.quadratic) out += problem_.quadratic(z_.matrix()) + problem_.linear;
  return out;
}

bool LeastStepMethod::converged(double complementarity) {
  const double mu = complementarity / static_cast<double>(slack.line.size());
  if (!std::isfinite(mu)) {
    throw SolverFailure("a repair step holds numbers that are not finite",
                        "check the design for degenerate tiles");
  }
  const Parts l = parts(multiplier.line), z = parts(slack.line);
  residual_ = rows_times(problem_, z_.matrix()).array() + c_.array() + z.e - z.s;
  dual_ = gradient().array() - transposed_times(problem_, l.s.matrix()).array() - l.low + l.high;
  unpaid_ = penalty_ - l.s - l.e;
  const double infeasible = rows_ > 0 ? residual_.abs().maxCoeff() : 0.0;
  const double unpaid = rows_ > 0 ? unpaid_.abs().maxCoeff() : 0.0;
  const double dual = std::max(dual_.abs().maxCoeff(), unpaid / (1 + problem_.sparse_penalty));
  // Conjugate gradients leave a dual residual.
  if (problem_.quadratic) return mu < 1e-4 && infeasible < 1e-6 && dual < 1e-2;
  return mu < 1e-10 && infeasible < 1e-9 && dual < 1e-6;
}

bool LeastStepMethod::factorize(const std::vector<ConeScaling>&) {
  scale_ = parts(slack.line / multiplier.line);
  weight_ = 1 / (scale_.s + scale_.e + least_give);
  assemble(problem_.sparse, weight_.head(sparse_), 1 + 1 / scale_.low + 1 / scale_.high, normal_);
  if (!normal_.factorize()) return false;
  if (dense_ > 0) {
    half_ = normal_.factor().solve_lower(dense_ranked_);
    Eigen::MatrixXd small = Eigen::MatrixXd((1 / weight_.tail(dense_)).matrix().asDiagonal());
    const int size = static_cast<int>(dense_), rank = static_cast<int>(n_);
    const double unit = 1;
    dsyrk_("L", "T", &size, &rank, &unit, half_.data(), &rank, &unit, small.data(), &size);
    small_.compute(small);
  }
  return true;
}

// Solution of the Newton system without the quadratic map.
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

// Solution of the Newton system, refined once; with a quadratic map by conjugate gradients,
// preconditioned by all the rest.
VectorXd LeastStepMethod::solve(const VectorXd& right) const {
  VectorXd z = solve_rows(right);
  if (!problem_.quadratic) return z + solve_rows(right - multiply_rows(z));
  VectorXd p = z, r = right, y = z;
  z.setZero();
  double now = r.dot(y);
  const double goal = krylov_tolerance * krylov_tolerance * now;
  for (int k = 0; k < most_krylov_iterations && now > goal; ++k) {
    const VectorXd along = multiply_rows(p) + problem_.quadratic(p);
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

ConeStep LeastStepMethod::newton(const ConePoint& shift) {
  const Parts to = parts(shift.line);
  const ArrayXd free = to.e - scale_.e * unpaid_;
  const ArrayXd k = -residual_ - free + to.s;
  dz_ = solve((transposed_times(problem_, (weight_ * k).matrix()).array() - dual_ +
               to.low / scale_.low - to.high / scale_.high)
                  .matrix());
  const ArrayXd m = weight_ * (k - rows_times(problem_, dz_.matrix()).array());
  return {{joined({to.s - scale_.s * m, free + scale_.e * m, dz_, -dz_})},
          {joined({m, unpaid_ - m, (to.low - dz_) / scale_.low, (to.high + dz_) / scale_.high})}};
}

LeastStep LeastStepMethod::run() {
  LeastStep out;
  out.solve = solve_cone_problem(*this, max_iterations);
  const Parts l = parts(multiplier.line);
  out.z = z_.max(problem_.lower.array()).min(problem_.upper.array());
  out.sparse_multiplier = l.s.head(sparse_);
  out.dense_multiplier = l.s.tail(dense_);
  out.lower_multiplier = l.low;
  out.upper_multiplier = l.high;
  return out;
}

}  // namespace

LeastStep solve_least_step(const LeastStepProblem& problem) {
  return LeastStepMethod(problem).run();
}

}  // namespace curveups
