// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/interior_point.hpp"

#include <cmath>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr double to_boundary = 0.995;    // largest share of the way to a bound that a step may go
constexpr double barrier_accuracy = 10;  // optimality error, in units of mu, before mu is lowered
// Energy per mm: ten times less changes the energy by a few parts in 1e5 and takes a third more
// iterations.
constexpr double gradient_accuracy = 1e-3;
constexpr double last_level = 3;  // in units of mu_end: no level is worth its steps below that
constexpr int max_halvings = 12;

// Shortens a step so that value + length change stays positive.
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
  using Values = std::vector<std::vector<Residuals::Value>>;

  // memory: values of an earlier linearization, to be overwritten.
  Linearization(int blocks, const ResidualsList& energies, const ResidualsList& constraints,
                Values memory)
      : values(std::move(memory)) {
    values.resize(constraints.size());
    std::vector<Coupling> couplings;
    for (const auto& energy : energies) {
      first.push_back(static_cast<int>(couplings.size()));
      energy->couple(couplings);
    }
    for (std::size_t c = 0; c < constraints.size(); ++c) {
      first.push_back(static_cast<int>(couplings.size()));
      constraints[c]->couple(couplings);
      values[c].resize(constraints[c]->element_count());
    }
    const auto pattern =
        std::make_shared<const BlockPattern>(std::vector<char>(blocks, 1), couplings);
    matrix = std::make_unique<BlockMatrix<9>>(pattern);
    constraint_matrix = std::make_unique<BlockMatrix<9>>(pattern);
    gradient.resize(blocks, Residuals::width);
    pull.resize(blocks, Residuals::width);
  }

  // Optimality error of the barrier problem with parameter mu.
  double error(double mu) const {
    const double excess = std::max(0.0, dual_error - gradient_accuracy);
    return std::max({excess, largest_residual, products.largest - mu, mu - products.least});
  }

  std::unique_ptr<BlockMatrix<9>> matrix, constraint_matrix;
  std::vector<int> first;  // coupling of each energy, then of each constraint
  Vector gradient;         // of the energies
  Vector pull;             // J^T m and the bounds' multipliers
  Values values;
  double residual_sum = 0, largest_residual = 0;  // residual c(z) - s
  double largest_violation = 0;                   // of c(z) >= 0
  double dual_error = 0;
  Complementarity products;
};

struct InteriorPoint::Step {
  Vector z;
  Vectors slack, multiplier;
  Eigen::VectorXd lower_multiplier, upper_multiplier;
  double primal_length, dual_length;  // longest that keep slacks and multipliers positive
  double decrease;                    // slope of the barrier function along the step
};

// Moves unknowns inside their bounds.
void InteriorPoint::begin(Vector& z, double mu) {
  lower_multiplier_.resize(static_cast<Eigen::Index>(bounds_.size()));
  upper_multiplier_.resize(lower_multiplier_.size());
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const auto& [block, unknown, lower, upper] = bounds_[k];
    const double distance = std::min(0.01, 0.1 * (upper - lower));
    double& value = z(block, unknown);
    value = std::clamp(value, lower + distance, upper - distance);
    lower_multiplier_(k) = mu / (value - lower);
    upper_multiplier_(k) = mu / (upper - value);
  }
  slack_.assign(constraints_.size(), {});
  multiplier_.assign(constraints_.size(), {});
  take_new_constraints(z, mu);
}

void InteriorPoint::take_new_constraints(const Vector& z, double mu) {
  // Far below sqrt(mu) a slack would take many steps to get away from zero.
  const double least = std::clamp(std::sqrt(mu), 1e-3, 0.05);
  Residuals::Value value;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const int old = static_cast<int>(slack_[c].size()), count = constraints_[c]->element_count();
    slack_[c].conservativeResize(count);
    multiplier_[c].conservativeResize(count);
    for (int e = old; e < count; ++e) {
      constraints_[c]->at(e, z, false, value);
      slack_[c](e) = std::max(value.value(0), least);
      multiplier_[c](e) = mu / slack_[c](e);
    }
  }
}

// Linearises energies and constraints in parallel, each into a matrix of its own.
void InteriorPoint::linearize(const Vector& z, Linearization& at) const {
  parallel_for(2, [&](int part) {
    if (part == 1) {
      linearize_constraints(z, at);
      linearize_bounds(z, at);
      return;
    }
    at.matrix->set_zero();
    at.gradient.setZero();
    for (std::size_t e = 0; e < energies_.size(); ++e) {
      energies_[e]->derivatives(z, at.gradient, at.matrix.get(), at.first[e]);
    }
  });
  at.matrix->add(*at.constraint_matrix);
  // Large multipliers make the dual part coarser.
  const double scale = std::max(1.0, at.products.sum / static_cast<double>(at.products.count));
  at.dual_error = (at.gradient - at.pull).cwiseAbs().maxCoeff() / (10 * scale);
}

void InteriorPoint::linearize_constraints(const Vector& z, Linearization& at) const {
  at.constraint_matrix->set_zero();
  at.pull.setZero();
  at.residual_sum = at.largest_residual = at.largest_violation = 0;
  at.products = {};
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    const Residuals& constraint = *constraints_[c];
    const int first = at.first[energies_.size() + c], rows = 1 + constraint.curvature_rows();
    auto make = [&](int begin, int end, int) {
      for (int e = begin; e < end; ++e) constraint.at(e, z, true, at.values[c][e]);
    };
    auto take = [&](int begin, int end, int) {
      for (int e = begin; e < end; ++e) {
        const auto& value = at.values[c][e];
        const double m = multiplier_[c](e), s = slack_[c](e), weights[2] = {m / s, m};
        constraint.add_row(e, value, 0, m, at.pull);
        constraint.add_products(e, value, rows, weights, first, *at.constraint_matrix);
        const double residual = std::abs(value.value(0) - s);
        at.residual_sum += residual;
        at.largest_residual = std::max(at.largest_residual, residual);
        at.largest_violation = std::max(at.largest_violation, -value.value(0));
        at.products.add(m, s);
      }
    };
    parallel_gather(constraint.element_count(), make, take);
  }
}

void InteriorPoint::linearize_bounds(const Vector& z, Linearization& at) const {
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const auto& [block, unknown, lower, upper] = bounds_[k];
    const double low = z(block, unknown) - lower, high = upper - z(block, unknown);
    const double ml = lower_multiplier_(k), mh = upper_multiplier_(k);
    at.pull(block, unknown) += ml - mh;
    at.constraint_matrix->diagonal(block, unknown) += ml / low + mh / high;
    at.products.add(ml, low);
    at.products.add(mh, high);
  }
}

InteriorPoint::Vector InteriorPoint::right_side(const Vector& z, double mu,
                                                const Linearization& at) const {
  Vector right = -at.gradient;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    for (int e = 0; e < constraints_[c]->element_count(); ++e) {
      const auto& value = at.values[c][e];
      const double s = slack_[c](e), pull = (mu - multiplier_[c](e) * (value.value(0) - s)) / s;
      constraints_[c]->add_row(e, value, 0, pull, right);
    }
  }
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const auto& [block, unknown, lower, upper] = bounds_[k];
    const double value = z(block, unknown);
    right(block, unknown) += mu / (value - lower) - mu / (upper - value);
  }
  return right;
}

bool InteriorPoint::solve_step(const Vector& z, double mu, Linearization& at, double& damping,
                               Step& step) const {
  bool factorized = false;
  for (int attempt = 0; attempt < 12 && !factorized; ++attempt) {
    factorized = at.matrix->factorize(damping, 1e-9);
    if (!factorized) damping = std::max(1e-6, 10 * damping);
  }
  if (!factorized) return false;
  const Vector right = right_side(z, mu, at);
  const Eigen::MatrixXd solution =
      at.matrix->solve(Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()));
  step.z = Eigen::Map<const Vector>(solution.data(), right.rows(), Residuals::width);
  step.primal_length = step.dual_length = 1;
  step.decrease = (at.gradient.array() * step.z.array()).sum();
  step_slacks(mu, at, step);
  step_bounds(z, mu, step);
  return true;
}

void InteriorPoint::step_slacks(double mu, const Linearization& at, Step& step) const {
  step.slack = slack_;
  step.multiplier = multiplier_;
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    for (int e = 0; e < constraints_[c]->element_count(); ++e) {
      const auto& value = at.values[c][e];
      const double s = slack_[c](e), m = multiplier_[c](e),
                   ds = constraints_[c]->dot_row(e, value, 0, step.z) + value.value(0) - s;
      step.slack[c](e) = ds;
      step.multiplier[c](e) = mu / s - m - m / s * ds;
      step.decrease -= mu * ds / s;
      limit(s, ds, step.primal_length);
      limit(m, step.multiplier[c](e), step.dual_length);
    }
  }
}

void InteriorPoint::step_bounds(const Vector& z, double mu, Step& step) const {
  step.lower_multiplier.resize(lower_multiplier_.size());
  step.upper_multiplier.resize(upper_multiplier_.size());
  for (std::size_t k = 0; k < bounds_.size(); ++k) {
    const auto& [block, unknown, lower, upper] = bounds_[k];
    const double low = z(block, unknown) - lower, high = upper - z(block, unknown),
                 d = step.z(block, unknown), ml = lower_multiplier_(k), mh = upper_multiplier_(k);
    step.lower_multiplier(k) = mu / low - ml * (1 + d / low);
    step.upper_multiplier(k) = mu / high - mh * (1 - d / high);
    step.decrease -= mu * (d / low - d / high);
    limit(low, d, step.primal_length);
    limit(high, -d, step.primal_length);
    limit(ml, step.lower_multiplier(k), step.dual_length);
    limit(mh, step.upper_multiplier(k), step.dual_length);
  }
}

double InteriorPoint::merit(const Vector& z, const Vectors& slack, double mu,
                            double penalty) const {
  double f = 0, logs = 0, violation = 0;
  for (const auto& energy : energies_) f += energy->value(z);
  for (std::size_t c = 0; c < constraints_.size(); ++c) {
    violation += parallel_sum(constraints_[c]->element_count(), [&](int e) {
      Residuals::Value value;
      constraints_[c]->at(e, z, false, value);
      return std::abs(value.value(0) - slack[c](e));
    });
    logs += slack[c].array().log().sum();
  }
  for (const auto& [block, unknown, lower, upper] : bounds_) {
    logs += std::log(z(block, unknown) - lower) + std::log(upper - z(block, unknown));
  }
  return f - mu * logs + penalty * violation;
}

bool InteriorPoint::search(Vector& z, double mu, double penalty, double residual_sum,
                           const Step& step, double& length) {
  const double slope = step.decrease - penalty * residual_sum;
  const double before = merit(z, slack_, mu, penalty);
  Vectors slack = slack_;
  for (int halving = 0; halving < max_halvings; ++halving) {
    if (halving > 0) length *= 0.5;
    const Vector trial = z + length * step.z;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      slack[c] = slack_[c] + length * step.slack[c];
    }
    // Rounding of the merit function itself must not stop the last steps.
    if (merit(trial, slack, mu, penalty) <=
        before + 1e-4 * length * slope + 1e-12 * std::abs(before)) {
      z = trial;
      slack_ = std::move(slack);
      return true;
    }
  }
  return false;
}

SolveReport InteriorPoint::run(Vector& z, const Levels& levels, int max_iterations,
                               const std::string& what, const Progress& progress,
                               const Discover& discover) {
  SolveReport report;
  try {
    iterate(z, levels, max_iterations, what, progress, discover, report);
  } catch (const Cancelled&) {
    report.status = SolveStatus::stopped;
  }
  const Finishing finishing;
  report.residual = largest_violation(constraints_, z);
  return report;
}

void InteriorPoint::iterate(Vector& z, const Levels& levels, int max_iterations,
                            const std::string& what, const Progress& progress,
                            const Discover& discover, SolveReport& report) {
  const auto& [mu_start, mu_end, violation] = levels;
  double mu = mu_start, damping = 0, penalty = 1;
  const double span = std::log(mu_start / mu_end);
  begin(z, mu);
  const int blocks = static_cast<int>(z.rows());
  std::unique_ptr<Linearization> linearization;
  const auto linearize_anew = [&] {
    Linearization::Values memory;
    if (linearization) memory = std::move(linearization->values);
    linearization.reset();
    linearization =
        std::make_unique<Linearization>(blocks, energies_, constraints_, std::move(memory));
  };
  linearize_anew();
  Step step;
  for (; report.iterations < max_iterations; ++report.iterations) {
    linearize(z, *linearization);
    if (!keep_going(progress, what, span > 0 ? std::log(mu_start / mu) / span : 1.0)) {
      report.status = SolveStatus::stopped;
      break;
    }
    if (linearization->error(mu) <= barrier_accuracy * mu) {
      if (discover && discover(z, mu)) {
        take_new_constraints(z, mu);
        linearize_anew();
        linearize(z, *linearization);
      } else if (mu <= mu_end && linearization->largest_violation <= violation) {
        report.status = SolveStatus::converged;
        break;
      }
      while (mu > mu_end && linearization->error(mu) <= barrier_accuracy * mu) {
        mu = std::min(0.2 * mu, std::pow(mu, 1.5));
        if (mu < last_level * mu_end) mu = mu_end;
      }
    }
    Linearization& at = *linearization;
    if (!solve_step(z, mu, at, damping, step)) break;
    // The penalty that makes the step a descent direction of the merit function.
    if (at.residual_sum > 1e-12) {
      penalty = std::max(penalty, 2 * step.decrease / at.residual_sum);
    }
    double length = step.primal_length;
    const bool accepted = search(z, mu, penalty, at.residual_sum, step, length);
    damping =
        length == step.primal_length && accepted ? 0.2 * damping : std::max(1e-3, 4 * damping);
    if (damping < 1e-8) damping = 0;
    if (damping > 1e6) break;
    if (!accepted) continue;
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      multiplier_[c] += step.dual_length * step.multiplier[c];
    }
    lower_multiplier_ += step.dual_length * step.lower_multiplier;
    upper_multiplier_ += step.dual_length * step.upper_multiplier;
  }
}

}  // namespace curveups
