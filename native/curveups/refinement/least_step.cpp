// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/refinement/least_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/numerics/block_matrix.hpp"

namespace curveups {
namespace {

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
  BlockMatrix<1> normal(normal_pattern(problem.sparse));

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
    assemble(problem.sparse, weight.head(sparse), 1 + ml / low + mh / high, normal);
    if (!normal.factorize()) break;
    Eigen::MatrixXd sides(n, 1 + dense);
    sides.col(0) = right;
    sides.rightCols(dense) = problem.dense;
    const Eigen::MatrixXd solved = normal.solve(sides);
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
