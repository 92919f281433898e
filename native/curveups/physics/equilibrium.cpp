// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "curveups/core/errors.hpp"

namespace curveups {

namespace {
constexpr double jacobi_damping = 0.6;
// Steps by an older factorization that cost about as much as one by a new one.
constexpr int max_reuses = 3;
// This share of the free vertices is settled by itself, with those within so many edges of it,
// where all others are pulled by less than this share of the largest force.
constexpr double worst_share = 0.01, rest_share = 0.1;
constexpr int edges_around = 2;
// Residual of the places by themselves: whole steps do the rest.
constexpr double settled = 1e-6;
}  // namespace

void MembraneEquilibrium::measure(MembraneState& state, double tolerance) const {
  double largest = 0, glued = 0;
  int count = 0;
  for (int v = 0; v < state.gradient.rows(); ++v) {
    const double force = state.gradient.row(v).norm();
    if (energy_.is_free(v)) {
      largest = std::max(largest, force);
    } else {
      glued += force;
      ++count;
    }
  }
  state.solve.residual = glued > 0 ? largest / (glued / count) : largest;
  if (state.solve.residual <= tolerance) state.solve.status = SolveStatus::converged;
}

// Only where what is left is in a few places.
void MembraneEquilibrium::settle_worst(MembraneState& state, double tolerance) const {
  const int count = static_cast<int>(state.gradient.rows());
  auto force = [&](int v) { return state.gradient.row(v).norm(); };
  std::vector<double> forces;
  for (int v = 0; v < count; ++v) {
    if (energy_.is_free(v)) forces.push_back(force(v));
  }
  const auto rest = forces.begin() + static_cast<int>(worst_share * forces.size());
  std::nth_element(forces.begin(), rest, forces.end(), std::greater<double>());
  const double level = *rest;
  if (!(level < rest_share * *std::max_element(forces.begin(), forces.end()))) return;
  std::vector<char> worst(count);
  for (int v = 0; v < count; ++v) {
    worst[v] = energy_.is_free(v) && force(v) > level;
  }
  MembranePart part = energy_.part_around(std::move(worst), edges_around);
  MembraneEquilibrium alone(std::move(part.energy));
  Points3 start(static_cast<Eigen::Index>(part.vertices.size()), 3);
  for (int k = 0; k < start.rows(); ++k) start.row(k) = state.x.row(part.vertices[k]);
  EquilibriumOptions options;
  options.max_iterations = 20;
  options.sweeps = 0;
  options.tolerance = settled;
  const Points3 places = alone.solve(start, options).x;
  Points3 x = state.x, gradient;
  for (int k = 0; k < start.rows(); ++k) x.row(part.vertices[k]) = places.row(k);
  const double energy = energy_.gradient(x, gradient);
  if (!(energy <= state.energy)) return;
  state.x = std::move(x);
  state.energy = energy;
  state.gradient = std::move(gradient);
  measure(state, tolerance);
}

bool MembraneEquilibrium::factorize(const Points3& x, Points3& gradient) {
  energy_.gradient(x, gradient, &hessian_);
  if (hessian_.factorize()) return true;
  // Only the plain density can be indefinite; its projection is not, but for rounding.
  energy_.gradient(x, gradient, &hessian_, true);
  return hessian_.factorize(0, 1e-8 * hessian_.mean_diagonal());
}

bool MembraneEquilibrium::direction(const Points3& gradient, Points3& out) const {
  const Eigen::MatrixXd step =
      hessian_.solve(-Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()));
  out = Eigen::Map<const Points3>(step.data(), gradient.rows(), 3);
  return step.allFinite();
}

MembraneState MembraneEquilibrium::solve(const Points3& start, const EquilibriumOptions& options,
                                         const Progress& progress, const std::string& what) {
  MembraneState state;
  state.energy = std::numeric_limits<double>::infinity();
  Points3 x = start, gradient, step;
  for (int sweep = 0; sweep <= options.sweeps; ++sweep) {
    const bool last = sweep == options.sweeps;
    const double energy =
        last ? energy_.gradient(x, gradient) : energy_.jacobi_direction(x, gradient, step);
    if (!(energy < state.energy)) break;
    state.x = x;
    state.energy = energy;
    std::swap(state.gradient, gradient);
    if (!last) x += jacobi_damping * step;
  }
  if (!std::isfinite(state.energy)) {
    throw SolverFailure("a membrane triangle has no area in the actuated shape",
                        "use the tension-field model");
  }
  measure(state, options.tolerance);
  if (energy_.free_count() == 0) return state;
  double reduction = 1;  // of the residual by the last step
  while (!state.solve.converged() && state.solve.iterations < options.max_iterations) {
    if (!keep_going(progress, what)) {
      state.solve.status = SolveStatus::stopped;
      break;
    }
    const bool reuse = options.few_factorizations && reduction <= 0.1 &&
                       state.solve.residual * std::pow(reduction, max_reuses) <= options.tolerance;
    if (!reuse && !factorize(state.x, gradient)) break;
    if (!direction(state.gradient, step)) break;
    ++state.solve.iterations;
    if (!reuse) ++state.factorizations;
    const double slope = step.cwiseProduct(state.gradient).sum();
    const double rounding = 1e-13 * std::abs(state.energy);
    bool accepted = false;
    for (double length = std::min(1.0, energy_.largest_step(state.x, step));
         length > 1e-8 && !accepted; length *= 0.5) {
      x = state.x + length * step;
      const double energy = energy_.gradient(x, gradient);
      if (energy <= state.energy + 1e-4 * length * slope + rounding) {
        state.x = x;
        state.energy = energy;
        std::swap(state.gradient, gradient);
        accepted = true;
      }
    }
    if (!accepted && !reuse) break;
    const double before = state.solve.residual;
    measure(state, options.tolerance);
    if (options.few_factorizations && !reuse && state.solve.residual > settled) {
      settle_worst(state, options.tolerance);
    }
    reduction = accepted ? state.solve.residual / before : 1;
  }
  return state;
}

void MembraneEquilibrium::respond(const Points3& x, std::vector<Points3>& displacements) const {
  if (energy_.free_count() == 0 || displacements.empty()) return;
  for (Points3& d : displacements) {
    for (int v = 0; v < d.rows(); ++v) {
      if (energy_.is_free(v)) d.row(v).setZero();
    }
  }
  std::vector<Points3> forces;
  energy_.second_derivatives(x, displacements, forces, nullptr);
  Eigen::MatrixXd right(x.size(), static_cast<Eigen::Index>(displacements.size()));
  for (std::size_t k = 0; k < forces.size(); ++k) {
    right.col(k) = -Eigen::Map<const Eigen::VectorXd>(forces[k].data(), x.size());
  }
  const Eigen::MatrixXd response = hessian_.solve(right);
  for (std::size_t k = 0; k < displacements.size(); ++k) {
    // Zero where a vertex is glued.
    displacements[k] += Eigen::Map<const Points3>(response.col(k).data(), x.rows(), 3);
  }
}

Points3 prolong(const MembraneMesh& fine, const Points3& coarse, const Points3& glued) {
  Points3 x(fine.vertex_count(), 3);
  const int old = static_cast<int>(coarse.rows());
  for (int v = 0; v < fine.vertex_count(); ++v) {
    if (fine.pin[v] >= 0) {
      x.row(v) = glued.row(v);
    } else if (v < old) {
      x.row(v) = coarse.row(v);
    } else {
      const std::array<int, 2>& parents = fine.parents[v - old];
      x.row(v) = 0.5 * (coarse.row(parents[0]) + coarse.row(parents[1]));
    }
  }
  return x;
}

}  // namespace curveups
