// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/least_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;

// I + C^T W C + diagonal over the sparse rows, on a pattern that stays: every product of two
// entries of a row has its place looked up once.
class WeightedNormal {
 public:
  explicit WeightedNormal(const SparseRows& rows) : rows_(rows) {
    const int n = static_cast<int>(rows.cols());
    std::vector<std::vector<int>> below(n);
    for (int j = 0; j < n; ++j) below[j].push_back(j);
    for_pairs([&](int high, int low, double) { below[low].push_back(high); });
    std::size_t entries = 0;
    for (std::vector<int>& list : below) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      entries += list.size();
    }
    matrix_.resize(n, n);
    matrix_.resizeNonZeros(static_cast<Eigen::Index>(entries));
    int at = 0;
    for (int j = 0; j < n; ++j) {
      matrix_.outerIndexPtr()[j] = at;
      for (int i : below[j]) matrix_.innerIndexPtr()[at++] = i;
    }
    matrix_.outerIndexPtr()[n] = at;
    for_pairs([&](int high, int low, double) {
      const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[low];
      const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[low + 1];
      place_.push_back(
          static_cast<int>(std::lower_bound(begin, end, high) - matrix_.innerIndexPtr()));
    });
  }

  const SparseMatrix& assemble(const ArrayXd& weight, const ArrayXd& diagonal) {
    double* value = matrix_.valuePtr();
    std::fill(value, value + matrix_.nonZeros(), 0.0);
    for (int j = 0; j < matrix_.cols(); ++j) value[matrix_.outerIndexPtr()[j]] = diagonal(j);
    std::size_t p = 0;
    for (int r = 0; r < rows_.rows(); ++r) {
      for (SparseRows::InnerIterator a(rows_, r); a; ++a) {
        const double scaled = weight(r) * a.value();
        for (SparseRows::InnerIterator b(rows_, r); b && b.col() <= a.col(); ++b) {
          value[place_[p++]] += scaled * b.value();
        }
      }
    }
    return matrix_;
  }

 private:
  template <class Body>
  void for_pairs(const Body& body) const {
    for (int r = 0; r < rows_.rows(); ++r) {
      for (SparseRows::InnerIterator a(rows_, r); a; ++a) {
        for (SparseRows::InnerIterator b(rows_, r); b && b.col() <= a.col(); ++b) {
          body(static_cast<int>(a.col()), static_cast<int>(b.col()), a.value());
        }
      }
    }
  }
  const SparseRows& rows_;
  SparseMatrix matrix_;
  std::vector<int> place_;
};

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

}  // namespace

LeastStep solve_least_step(const LeastStepProblem& problem) {
  const Eigen::Index n = problem.lower.size(), sparse = problem.sparse.rows(),
                     dense = problem.dense.cols(), rows = sparse + dense;
  VectorXd c(rows);
  c.head(sparse) = problem.sparse_value;
  c.tail(dense) = problem.dense_value;
  ArrayXd price(rows);
  price.head(sparse) = problem.sparse_price;
  price.tail(dense) = problem.dense_price;
  ArrayXd stiffness = ArrayXd::Zero(rows);
  stiffness.tail(dense) = problem.dense_stiffness;
  const VectorXd wanted = problem.wanted.size() > 0 ? problem.wanted : VectorXd::Zero(n);
  WeightedNormal normal(problem.sparse);
  SparseCholesky cholesky;

  const ArrayXd width = (problem.upper - problem.lower).array();
  ArrayXd z = (-problem.lower.array()).max(0.1 * width).min(0.9 * width) + problem.lower.array();
  // Start on the central path of complementarity `mu` as nearly as z allows.
  double mu = 1e-2;
  const ArrayXd at_start = rows_times(problem, z.matrix()).array() + c.array();
  ArrayXd s = at_start.max(0.1), e = (s - at_start).max(1e-3);
  // What e costs beyond its row's multiplier.
  ArrayXd m = (mu / s).min(0.5 * (price + stiffness * e)), slack_price = price + stiffness * e - m;
  ArrayXd ml = mu / (z - problem.lower.array()), mh = mu / (problem.upper.array() - z);

  LeastStep out;
  constexpr int most_iterations = 80;
  while (out.solve.iterations < most_iterations) {
    const ArrayXd low = z - problem.lower.array(), high = problem.upper.array() - z;
    const ArrayXd residual = rows_times(problem, z.matrix()).array() + c.array() + e - s;
    const ArrayXd dual =
        z - wanted.array() - transposed_times(problem, m.matrix()).array() - ml + mh;
    const double products =
        (s * m).sum() + (e * slack_price).sum() + (low * ml).sum() + (high * mh).sum();
    mu = products / static_cast<double>(2 * rows + 2 * n);
    if (!std::isfinite(mu)) {
      throw SolverFailure("a repair step holds numbers that are not finite",
                          "check the design for degenerate tiles");
    }
    const double infeasible = rows > 0 ? residual.abs().maxCoeff() : 0.0;
    const double unpriced_most =
        rows > 0 ? (price + stiffness * e - m - slack_price).abs().maxCoeff() : 0.0;
    if (mu < 1e-10 && infeasible < 1e-9 &&
        std::max(dual.abs().maxCoeff(), unpriced_most / (1 + problem.sparse_price)) < 1e-6) {
      out.solve.status = SolveStatus::converged;
      break;
    }
    ++out.solve.iterations;
    const double target = 0.15 * mu;
    const ArrayXd give = slack_price + stiffness * e;
    const ArrayXd unpriced = price + stiffness * e - m - slack_price;
    const ArrayXd weight = 1 / (s / m + e / give);
    const ArrayXd free = (target - e * (slack_price + unpriced)) / give;
    const ArrayXd k = -residual - free + target / m - s;
    const VectorXd right = wanted - z.matrix() +
                           transposed_times(problem, (m + weight * k).matrix()) +
                           (target / low - target / high).matrix();
    if (!cholesky.factorize(normal.assemble(weight.head(sparse), 1 + ml / low + mh / high))) break;
    Eigen::MatrixXd sides(n, 1 + dense);
    sides.col(0) = right;
    sides.rightCols(dense) = problem.dense;
    const Eigen::MatrixXd solved = cholesky.solve(sides);
    VectorXd dz = solved.col(0);
    if (dense > 0) {
      const auto response = solved.rightCols(dense);
      Eigen::MatrixXd small = problem.dense.transpose() * response;
      small.diagonal() += (1 / weight.tail(dense)).matrix();
      dz -= response * small.ldlt().solve(problem.dense.transpose() * dz);
    }
    if (!dz.allFinite()) break;
    const ArrayXd dm = weight * (k - rows_times(problem, dz).array());
    const ArrayXd de = free + e / give * dm, dl = stiffness * de - dm + unpriced,
                  ds = target / m - s - s / m * dm;
    const ArrayXd dml = target / low - ml - ml / low * dz.array(),
                  dmh = target / high - mh + mh / high * dz.array();
    const double primal = std::min({step_length(s, ds), step_length(e, de),
                                    step_length(low, dz.array()), step_length(high, -dz.array())});
    const double dual_step = std::min({step_length(m, dm), step_length(slack_price, dl),
                                       step_length(ml, dml), step_length(mh, dmh)});
    z += primal * dz.array();
    s += primal * ds;
    e += primal * de;
    m += dual_step * dm;
    // Kept apart from price - m, which cancels where a row stays unmet.
    slack_price += dual_step * dl;
    ml += dual_step * dml;
    mh += dual_step * dmh;
  }
  out.z = z;
  out.sparse_multiplier = m.head(sparse);
  out.dense_multiplier = m.tail(dense);
  out.lower_multiplier = ml;
  out.upper_multiplier = mh;
  return out;
}

}  // namespace curveups
