// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/interior_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr double to_boundary = 0.995;  // largest share of the way to a bound that a step may go
constexpr double gradient_accuracy =
    1e-4;  // energy per mm: far below what moves a tile by a micrometre
constexpr double barrier_accuracy = 10;  // optimality error, in units of mu, before mu is lowered

using Vectors = std::vector<Eigen::VectorXd>;

const double* unknowns(const LayoutState& state, int tile) {
  return tile < 0 ? nullptr : state.row(tile).data();
}

}  // namespace

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
  for (std::size_t f = 0; f < constraints_.size(); ++f) {
    const int old = static_cast<int>(slack_[f].size()), count = constraints_[f]->block_count();
    slack_[f].conservativeResize(count);
    multiplier_[f].conservativeResize(count);
    for (int b = old; b < count; ++b) {
      const auto [i, j] = constraints_[f]->tiles(b);
      constraints_[f]->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
      slack_[f](b) = std::max(block.value(0), 0.05);
      multiplier_[f](b) = mu / slack_[f](b);
    }
  }
}

double InteriorPoint::merit(const LayoutState& state, const Vectors& slack, double mu,
                            double penalty) const {
  const PinBounds& bounds = model_.geometry->pin_bounds;
  double f = 0, logs = 0, violation = 0;
  for (const auto& function : energies_) f += 0.5 * energy(*function, state);
  BlockValue block;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    for (int b = 0; b < constraints_[c]->block_count(); ++b) {
      const auto [i, j] = constraints_[c]->tiles(b);
      constraints_[c]->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
      violation += std::abs(block.value(0) - slack[c](b));
      logs += std::log(slack[c](b));
    }
  }
  logs += (state.rightCols<6>() - bounds.lower).array().log().sum() +
          (bounds.upper - state.rightCols<6>()).array().log().sum();
  return f - mu * logs + penalty * violation;
}

InteriorPointOutcome InteriorPoint::run(LayoutState& state, double mu_start, double mu_end,
                                        int max_iterations, const Progress& progress) {
  const PinBounds& bounds = model_.geometry->pin_bounds;
  const int tile_count = model_.tile_count();
  InteriorPointOutcome outcome;
  double mu = mu_start, damping = 0, penalty = 1;
  prepare(state, mu);
  std::vector<const BlockFunction*> functions;
  for (const auto& f : energies_) functions.push_back(f.get());
  for (const auto& f : constraints_) functions.push_back(f.get());
  NormalMatrix matrix(tile_count, functions);
  SparseCholesky cholesky;

  // Each constraint's derivatives are needed again for the slacks' step.
  std::vector<std::vector<BlockValue>> constraint_values(constraints_.size());
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    constraint_values[c].resize(constraints_[c]->block_count());
  }
  LayoutState gradient(tile_count, unknowns_per_tile), dual(tile_count, unknowns_per_tile),
      right(tile_count, unknowns_per_tile), step(tile_count, unknowns_per_tile);
  Vectors slack_step = slack_, multiplier_step = multiplier_;

  for (; outcome.iterations < max_iterations; ++outcome.iterations) {
    matrix.set_zero();
    gradient.setZero();
    BlockValue block;
    const double ones[largest_block] = {1, 1, 1, 1, 1, 1, 1, 1};
    for (std::size_t e = 0; e < energies_.size(); ++e) {
      const int dimension = energies_[e]->dimension();
      for (int b = 0; b < energies_[e]->block_count(); ++b) {
        const auto [i, j] = energies_[e]->tiles(b);
        energies_[e]->evaluate(b, unknowns(state, i), unknowns(state, j), true, block);
        for (int r = 0; r < dimension; ++r) {
          gradient.row(i) += block.value(r) * block.jacobian[0].row(r);
          if (j >= 0) gradient.row(j) += block.value(r) * block.jacobian[1].row(r);
        }
        matrix.add(static_cast<int>(e), b, block, dimension + energies_[e]->curvature_rows(), ones);
      }
    }
    dual = gradient;
    double violation = 0, largest_residual = 0, largest_product = 0, least_product = 1e300;
    double multiplier_sum = 0;
    long multiplier_count = 0;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      for (int b = 0; b < constraints_[c]->block_count(); ++b) {
        const auto [i, j] = constraints_[c]->tiles(b);
        BlockValue& value = constraint_values[c][b];
        constraints_[c]->evaluate(b, unknowns(state, i), unknowns(state, j), true, value);
        const double m = multiplier_[c](b), s = slack_[c](b), weights[2] = {m / s, m};
        dual.row(i) -= m * value.jacobian[0].row(0);
        if (j >= 0) dual.row(j) -= m * value.jacobian[1].row(0);
        matrix.add(static_cast<int>(energies_.size() + c), b, value,
                   1 + constraints_[c]->curvature_rows(), weights);
        violation += std::abs(value.value(0) - s);
        largest_residual = std::max(largest_residual, std::abs(value.value(0) - s));
        largest_product = std::max(largest_product, m * s);
        least_product = std::min(least_product, m * s);
        multiplier_sum += m;
        ++multiplier_count;
      }
    }
    for (int i = 0; i < tile_count; ++i) {
      for (int k = 0; k < 6; ++k) {
        const double low = state(i, 3 + k) - bounds.lower(i, k),
                     high = bounds.upper(i, k) - state(i, 3 + k);
        const double ml = lower_multiplier_(i, k), mh = upper_multiplier_(i, k);
        dual(i, 3 + k) += mh - ml;
        matrix.add_diagonal(i, 3 + k, ml / low + mh / high);
        largest_product = std::max({largest_product, ml * low, mh * high});
        least_product = std::min({least_product, ml * low, mh * high});
        multiplier_sum += ml + mh;
        multiplier_count += 2;
      }
    }
    // Optimality error of the barrier problem; large multipliers make the dual part coarser.
    const double scale = std::max(1.0, multiplier_sum / static_cast<double>(multiplier_count));
    const double dual_error = dual.cwiseAbs().maxCoeff() / (scale * 10);
    auto error = [&](double m) {
      const double excess = std::max(0.0, dual_error - gradient_accuracy);
      return std::max({excess, largest_residual, largest_product - m, m - least_product});
    };
    const double span = std::log(mu_start / mu_end);
    if (!keep_going(progress, "layout", span > 0 ? std::log(mu_start / mu) / span : 1.0)) {
      outcome.stopped = true;
      break;
    }
    if (mu <= mu_end && error(mu) <= barrier_accuracy * mu) {
      outcome.converged = true;
      break;
    }
    while (mu > mu_end && error(mu) <= barrier_accuracy * mu) {
      mu = std::max(mu_end, std::min(0.2 * mu, std::pow(mu, 1.5)));
    }

    right = -gradient;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      for (int b = 0; b < constraints_[c]->block_count(); ++b) {
        const auto [i, j] = constraints_[c]->tiles(b);
        const BlockValue& value = constraint_values[c][b];
        const double s = slack_[c](b), m = multiplier_[c](b);
        const double pull = (mu - m * (value.value(0) - s)) / s;
        right.row(i) += pull * value.jacobian[0].row(0);
        if (j >= 0) right.row(j) += pull * value.jacobian[1].row(0);
      }
    }
    for (int i = 0; i < tile_count; ++i) {
      for (int k = 0; k < 6; ++k) {
        right(i, 3 + k) += mu / (state(i, 3 + k) - bounds.lower(i, k)) -
                           mu / (bounds.upper(i, k) - state(i, 3 + k));
      }
    }
    bool factorized = false;
    for (int attempt = 0; attempt < 12 && !factorized; ++attempt) {
      factorized = cholesky.factorize(matrix.assemble(damping, 1e-9));
      if (!factorized) damping = std::max(1e-6, 10 * damping);
    }
    if (!factorized) {
      throw SolverFailure("the layout's linear system can't be factorized",
                          "check the target for degenerate triangles");
    }
    const Eigen::VectorXd solution =
        cholesky.solve(Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()));
    step = Eigen::Map<const LayoutState>(solution.data(), tile_count, unknowns_per_tile);

    double primal = 1, dual_step = 1;
    double decrease = (gradient.array() * step.array()).sum();  // of the barrier function, linear
    auto limit = [](double value, double change, double& length) {
      if (change < 0) length = std::min(length, -to_boundary * value / change);
    };
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      for (int b = 0; b < constraints_[c]->block_count(); ++b) {
        const auto [i, j] = constraints_[c]->tiles(b);
        const BlockValue& value = constraint_values[c][b];
        double change = value.jacobian[0].row(0).dot(step.row(i));
        if (j >= 0) change += value.jacobian[1].row(0).dot(step.row(j));
        const double s = slack_[c](b), m = multiplier_[c](b);
        const double ds = change + value.value(0) - s;
        slack_step[c](b) = ds;
        multiplier_step[c](b) = mu / s - m - m / s * ds;
        decrease -= mu * ds / s;
        limit(s, ds, primal);
        limit(m, multiplier_step[c](b), dual_step);
      }
    }
    Array6 lower_step(tile_count, 6), upper_step(tile_count, 6);
    for (int i = 0; i < tile_count; ++i) {
      for (int k = 0; k < 6; ++k) {
        const double d = step(i, 3 + k), low = state(i, 3 + k) - bounds.lower(i, k),
                     high = bounds.upper(i, k) - state(i, 3 + k);
        lower_step(i, k) = mu / low - lower_multiplier_(i, k) * (1 + d / low);
        upper_step(i, k) = mu / high - upper_multiplier_(i, k) * (1 - d / high);
        decrease -= mu * d / low - mu * d / high;
        limit(low, d, primal);
        limit(high, -d, primal);
        limit(lower_multiplier_(i, k), lower_step(i, k), dual_step);
        limit(upper_multiplier_(i, k), upper_step(i, k), dual_step);
      }
    }
    // The penalty that makes the step a descent direction of the merit function.
    if (violation > 1e-12) penalty = std::max(penalty, 2 * decrease / violation);
    const double slope = decrease - penalty * violation;
    const double before = merit(state, slack_, mu, penalty);
    LayoutState trial;
    Vectors trial_slack = slack_;
    double length = primal;
    bool accepted = false;
    for (int halving = 0; halving < 12; ++halving, length *= 0.5) {
      trial = state + length * step;
      for (std::size_t c = 0; c < constraints_.size(); ++c) {
        trial_slack[c] = slack_[c] + length * slack_step[c];
      }
      const double after = merit(trial, trial_slack, mu, penalty);
      // Rounding of the merit function itself must not stop the last steps.
      if (after <= before + 1e-4 * length * slope + 1e-12 * std::abs(before)) {
        accepted = true;
        break;
      }
    }
    damping = length == primal ? 0.2 * damping : std::max(1e-3, 4 * damping);
    if (damping < 1e-8) damping = 0;
    if (!accepted) {
      if (damping > 1e6) break;
      continue;
    }
    state = trial;
    slack_ = trial_slack;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      multiplier_[c] += dual_step * multiplier_step[c];
    }
    lower_multiplier_ += dual_step * lower_step;
    upper_multiplier_ += dual_step * upper_step;
  }

  BlockValue block;
  for (const auto& constraint : constraints_) {
    for (int b = 0; b < constraint->block_count(); ++b) {
      const auto [i, j] = constraint->tiles(b);
      constraint->evaluate(b, unknowns(state, i), unknowns(state, j), false, block);
      outcome.largest_violation = std::max(outcome.largest_violation, -block.value(0));
    }
  }
  return outcome;
}

}  // namespace curveups
