// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/interior_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

constexpr double to_boundary = 0.995;    // largest share of the way to a bound that a step may go
constexpr double barrier_accuracy = 10;  // optimality error, in units of mu, before mu is lowered
// Energy per mm: far below what moves a tile by a micrometre.
constexpr double gradient_accuracy = 1e-4;
constexpr int most_halvings = 12;
constexpr double ones[largest_block] = {1, 1, 1, 1, 1, 1, 1, 1};

const double* unknowns(const LayoutState& state, int tile) {
  return tile < 0 ? nullptr : state.row(tile).data();
}

std::vector<const BlockFunction*> pointers(const BlockFunctions& a, const BlockFunctions& b) {
  std::vector<const BlockFunction*> out;
  for (const auto& function : a) out.push_back(function.get());
  for (const auto& function : b) out.push_back(function.get());
  return out;
}

// Shortens a step so that value + length change stays a share of the way from zero.
void limit(double value, double change, double& length) {
  if (change < 0) length = std::min(length, -to_boundary * value / change);
}

// The range of complementarity products and the sum of multipliers.
struct Complementarity {
  double least = std::numeric_limits<double>::infinity(), largest = 0, sum = 0;
  long count = 0;
  void add(double multiplier, double slack) {
    least = std::min(least, multiplier * slack);
    largest = std::max(largest, multiplier * slack);
    sum += multiplier;
    ++count;
  }
};

}  // namespace

// Everything at an iterate that the step and the stopping test need.
struct InteriorPoint::Linearization {
  Linearization(int tile_count, const BlockFunctions& energies, const BlockFunctions& constraints)
      : matrix(tile_count, pointers(energies, constraints)),
        constraint_matrix(matrix),
        gradient(tile_count, unknowns_per_tile),
        pull(tile_count, unknowns_per_tile),
        values(constraints.size()) {
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      values[c].resize(constraints[c]->block_count());
    }
  }

  // Optimality error of the barrier problem with parameter mu.
  double error(double mu) const {
    const double excess = std::max(0.0, dual_error - gradient_accuracy);
    return std::max({excess, largest_residual, products.largest - mu, mu - products.least});
  }

  NormalMatrix matrix, constraint_matrix;
  LayoutState gradient;  // of the energies
  LayoutState pull;  // J_c^T m and the bounds' multipliers: what the constraints hold against it
  std::vector<std::vector<BlockValue>> values;    // of the constraints
  double residual_sum = 0, largest_residual = 0;  // of c(z) - s
  double dual_error = 0;
  Complementarity products;
};

struct InteriorPoint::Step {
  LayoutState state;
  Vectors slack, multiplier;
  Array6 lower_multiplier, upper_multiplier;
  double primal_length, dual_length;  // longest that keep slacks and multipliers positive
  double decrease;                    // slope of the barrier function along the step
};

InteriorPoint::InteriorPoint(const LayoutModel& model)
    : model_(model),
      energies_(make_energies(model, false)),
      constraints_(make_constraints(model)) {}

// Gives new constraints slacks and multipliers, and moves insets inside their bounds.
void InteriorPoint::prepare(LayoutState& state, double mu) {
  const PinBounds& bounds = model_.geometry->pin_bounds;
  for (int i = 0; i < model_.tile_count(); ++i) {
    for (int k = 0; k < 6; ++k) {
      const double low = bounds.lower(i, k), high = bounds.upper(i, k),
                   room = std::min(0.01, 0.1 * (high - low));
      state(i, 3 + k) = std::clamp(state(i, 3 + k), low + room, high - room);
    }
  }
  if (lower_multiplier_.rows() == 0) {
    lower_multiplier_ = mu / (state.rightCols<6>() - bounds.lower).array();
    upper_multiplier_ = mu / (bounds.upper - state.rightCols<6>()).array();
  }
  slack_.resize(constraints_.size());
  multiplier_.resize(constraints_.size());
  BlockValue block;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const int old = static_cast<int>(slack_[c].size()), count = constraints_[c]->block_count();
    slack_[c].conservativeResize(count);
    multiplier_[c].conservativeResize(count);
    for (int b = old; b < count; ++b) {
      const auto [i, j] = constraints_[c]->tiles(b);
      constraints_[c]->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
      slack_[c](b) = std::max(block.value(0), 0.05);
      multiplier_[c](b) = mu / slack_[c](b);
    }
  }
}

// Energies and constraints are taken at once, each into a matrix of its own: the sums do not depend
// on the number of threads.
void InteriorPoint::linearize(const LayoutState& state, Linearization& at) const {
  auto energies = [&] {
    at.matrix.set_zero();
    at.gradient.setZero();
    BlockValue block;
    for (std::size_t e = 0; e < energies_.size(); ++e) {
      const int dimension = energies_[e]->dimension();
      const int rows = dimension + energies_[e]->curvature_rows();
      for (int b = 0; b < energies_[e]->block_count(); ++b) {
        const auto [i, j] = energies_[e]->tiles(b);
        energies_[e]->evaluate(b, unknowns(state, i), unknowns(state, j), true, block);
        for (int r = 0; r < dimension; ++r) {
          at.gradient.row(i) += block.value(r) * block.jacobian[0].row(r);
          if (j >= 0) at.gradient.row(j) += block.value(r) * block.jacobian[1].row(r);
        }
        at.matrix.add(static_cast<int>(e), b, block, rows, ones);
      }
    }
  };
  auto constraints = [&] {
    at.constraint_matrix.set_zero();
    at.pull.setZero();
    at.residual_sum = at.largest_residual = 0;
    at.products = {};
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      const int rows = 1 + constraints_[c]->curvature_rows();
      for (int b = 0; b < constraints_[c]->block_count(); ++b) {
        const auto [i, j] = constraints_[c]->tiles(b);
        BlockValue& value = at.values[c][b];
        constraints_[c]->evaluate(b, unknowns(state, i), unknowns(state, j), true, value);
        const double m = multiplier_[c](b), s = slack_[c](b), weights[2] = {m / s, m};
        at.pull.row(i) += m * value.jacobian[0].row(0);
        if (j >= 0) at.pull.row(j) += m * value.jacobian[1].row(0);
        at.constraint_matrix.add(static_cast<int>(energies_.size() + c), b, value, rows, weights);
        const double residual = std::abs(value.value(0) - s);
        at.residual_sum += residual;
        at.largest_residual = std::max(at.largest_residual, residual);
        at.products.add(m, s);
      }
    }
    const PinBounds& bounds = model_.geometry->pin_bounds;
    for (int i = 0; i < model_.tile_count(); ++i) {
      for (int k = 0; k < 6; ++k) {
        const double low = state(i, 3 + k) - bounds.lower(i, k),
                     high = bounds.upper(i, k) - state(i, 3 + k);
        const double ml = lower_multiplier_(i, k), mh = upper_multiplier_(i, k);
        at.pull(i, 3 + k) += ml - mh;
        at.constraint_matrix.add_diagonal(i, 3 + k, ml / low + mh / high);
        at.products.add(ml, low);
        at.products.add(mh, high);
      }
    }
  };
  parallel_pair(energies, constraints);
  at.matrix.add(at.constraint_matrix);
  // Large multipliers make the dual part coarser.
  const double scale = std::max(1.0, at.products.sum / static_cast<double>(at.products.count));
  at.dual_error = (at.gradient - at.pull).cwiseAbs().maxCoeff() / (10 * scale);
}

bool InteriorPoint::solve_step(const LayoutState& state, double mu, Linearization& at,
                               SparseCholesky& cholesky, double& damping, Step& step) const {
  const PinBounds& bounds = model_.geometry->pin_bounds;
  LayoutState right = -at.gradient;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    for (int b = 0; b < constraints_[c]->block_count(); ++b) {
      const auto [i, j] = constraints_[c]->tiles(b);
      const BlockValue& value = at.values[c][b];
      const double s = slack_[c](b);
      const double pull = (mu - multiplier_[c](b) * (value.value(0) - s)) / s;
      right.row(i) += pull * value.jacobian[0].row(0);
      if (j >= 0) right.row(j) += pull * value.jacobian[1].row(0);
    }
  }
  const Array6 low = state.rightCols<6>() - bounds.lower,
               high = bounds.upper - state.rightCols<6>();
  right.rightCols<6>().array() += mu / low.array() - mu / high.array();

  bool factorized = false;
  for (int attempt = 0; attempt < 12 && !factorized; ++attempt) {
    factorized = cholesky.factorize(at.matrix.assemble(damping, 1e-9));
    if (!factorized) damping = std::max(1e-6, 10 * damping);
  }
  if (!factorized) return false;
  step.state = at.matrix.solve(cholesky, right);

  step.primal_length = step.dual_length = 1;
  step.decrease = (at.gradient.array() * step.state.array()).sum();
  step.slack = slack_;
  step.multiplier = multiplier_;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    for (int b = 0; b < constraints_[c]->block_count(); ++b) {
      const auto [i, j] = constraints_[c]->tiles(b);
      const BlockValue& value = at.values[c][b];
      double change = value.jacobian[0].row(0).dot(step.state.row(i));
      if (j >= 0) change += value.jacobian[1].row(0).dot(step.state.row(j));
      const double s = slack_[c](b), m = multiplier_[c](b);
      const double ds = change + value.value(0) - s;
      step.slack[c](b) = ds;
      step.multiplier[c](b) = mu / s - m - m / s * ds;
      step.decrease -= mu * ds / s;
      limit(s, ds, step.primal_length);
      limit(m, step.multiplier[c](b), step.dual_length);
    }
  }
  const auto d = step.state.rightCols<6>().array();
  step.lower_multiplier = mu / low.array() - lower_multiplier_.array() * (1 + d / low.array());
  step.upper_multiplier = mu / high.array() - upper_multiplier_.array() * (1 - d / high.array());
  step.decrease -= mu * (d / low.array() - d / high.array()).sum();
  for (int i = 0; i < model_.tile_count(); ++i) {
    for (int k = 0; k < 6; ++k) {
      limit(low(i, k), d(i, k), step.primal_length);
      limit(high(i, k), -d(i, k), step.primal_length);
      limit(lower_multiplier_(i, k), step.lower_multiplier(i, k), step.dual_length);
      limit(upper_multiplier_(i, k), step.upper_multiplier(i, k), step.dual_length);
    }
  }
  return true;
}

void InteriorPoint::forget() {
  slack_.clear();
  multiplier_.clear();
  lower_multiplier_.resize(0, 6);
  upper_multiplier_.resize(0, 6);
}

double InteriorPoint::merit(const LayoutState& state, const Vectors& slack, double mu,
                            double penalty) const {
  double f = 0, logs = 0, violation = 0;
  auto energies = [&] {
    for (const auto& function : energies_) f += 0.5 * energy(*function, state);
  };
  auto constraints = [&] {
    BlockValue block;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      for (int b = 0; b < constraints_[c]->block_count(); ++b) {
        const auto [i, j] = constraints_[c]->tiles(b);
        constraints_[c]->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
        violation += std::abs(block.value(0) - slack[c](b));
        logs += std::log(slack[c](b));
      }
    }
    const PinBounds& bounds = model_.geometry->pin_bounds;
    logs += (state.rightCols<6>() - bounds.lower).array().log().sum() +
            (bounds.upper - state.rightCols<6>()).array().log().sum();
  };
  parallel_pair(energies, constraints);
  return f - mu * logs + penalty * violation;
}

double InteriorPoint::largest_violation(const LayoutState& state) const {
  double largest = 0;
  BlockValue block;
  for (const auto& constraint : constraints_) {
    for (int b = 0; b < constraint->block_count(); ++b) {
      const auto [i, j] = constraint->tiles(b);
      constraint->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
      largest = std::max(largest, -block.value(0));
    }
  }
  return largest;
}

SolveReport InteriorPoint::run(LayoutState& state, double mu_start, double mu_end,
                               int max_iterations, const Progress& progress) {
  SolveReport outcome;
  double mu = mu_start, damping = 0, penalty = 1;
  const double span = std::log(mu_start / mu_end);
  prepare(state, mu);
  Linearization at(model_.tile_count(), energies_, constraints_);
  SparseCholesky cholesky(Ordering::as_given);
  Step step;
  LayoutState trial;
  Vectors trial_slack = slack_;
  for (; outcome.iterations < max_iterations; ++outcome.iterations) {
    linearize(state, at);
    if (!keep_going(progress, "layout", span > 0 ? std::log(mu_start / mu) / span : 1.0)) {
      outcome.status = SolveStatus::stopped;
      break;
    }
    if (mu <= mu_end && at.error(mu) <= barrier_accuracy * mu) {
      outcome.status = SolveStatus::converged;
      break;
    }
    while (mu > mu_end && at.error(mu) <= barrier_accuracy * mu) {
      mu = std::max(mu_end, std::min(0.2 * mu, std::pow(mu, 1.5)));
    }
    if (!solve_step(state, mu, at, cholesky, damping, step)) break;

    // The penalty that makes the step a descent direction of the merit function.
    if (at.residual_sum > 1e-12) {
      penalty = std::max(penalty, 2 * step.decrease / at.residual_sum);
    }
    const double slope = step.decrease - penalty * at.residual_sum;
    const double before = merit(state, slack_, mu, penalty);
    bool accepted = false;
    double length = step.primal_length;
    for (int halving = 0; halving < most_halvings && !accepted; ++halving) {
      if (halving > 0) length *= 0.5;
      trial = state + length * step.state;
      for (std::size_t c = 0; c < constraints_.size(); ++c) {
        trial_slack[c] = slack_[c] + length * step.slack[c];
      }
      // Rounding of the merit function itself must not stop the last steps.
      accepted = merit(trial, trial_slack, mu, penalty) <=
                 before + 1e-4 * length * slope + 1e-12 * std::abs(before);
    }
    damping =
        length == step.primal_length && accepted ? 0.2 * damping : std::max(1e-3, 4 * damping);
    if (damping < 1e-8) damping = 0;
    if (damping > 1e6) break;
    if (!accepted) continue;
    state = trial;
    slack_ = trial_slack;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      multiplier_[c] += step.dual_length * step.multiplier[c];
    }
    lower_multiplier_ += step.dual_length * step.lower_multiplier;
    upper_multiplier_ += step.dual_length * step.upper_multiplier;
  }
  outcome.residual = largest_violation(state);
  return outcome;
}

}  // namespace curveups
