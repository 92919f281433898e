// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {

namespace {
constexpr int max_iterations = 200;
constexpr double tolerance = 1e-10;  // residual
// Accuracy of a Newton step: this at most, and the residual, for quadratic convergence.
constexpr double largest_forcing = 0.1;
}  // namespace

void MembraneEquilibrium::measure(MembraneState& state) const {
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

bool MembraneEquilibrium::factorize(const Points3& x) {
  if (energy_.free_count() == 0) return true;
  Points3 gradient;
  energy_.gradient(x, gradient, &hessian_);
  return hessian_.factorize();
}

bool MembraneEquilibrium::direction(const MembraneState& state, Points3& out) {
  Points3 gradient;
  energy_.gradient(state.x, gradient, &hessian_);
  const Eigen::VectorXd step = hessian_.solve_iteratively(
      -Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size()),
      std::min(largest_forcing, state.solve.residual));
  out = Eigen::Map<const Points3>(step.data(), gradient.rows(), 3);
  return step.allFinite();
}

MembraneState MembraneEquilibrium::solve(const Points3& start, const Progress& progress,
                                         const std::string& what) {
  MembraneState state;
  state.x = start;
  state.energy = energy_.gradient(start, state.gradient);
  if (!std::isfinite(state.energy)) {
    throw SolverFailure("a membrane triangle has no area in the actuated shape",
                        "use the tension-field model");
  }
  measure(state);
  if (energy_.free_count() == 0) return state;
  Points3 x, gradient, step;
  while (!state.solve.converged() && state.solve.iterations < max_iterations) {
    if (!keep_going(progress, what)) {
      state.solve.status = SolveStatus::stopped;
      break;
    }
    if (!direction(state, step)) break;
    ++state.solve.iterations;
    const double slope = step.cwiseProduct(state.gradient).sum();
    const double rounding = 1e-13 * std::abs(state.energy);
    bool accepted = false;
    for (double length = 1; length > 1e-8 && !accepted; length *= 0.5) {
      x = state.x + length * step;
      const double energy = energy_.gradient(x, gradient);
      if (energy <= state.energy + 1e-4 * length * slope + rounding) {
        state.x = x;
        state.energy = energy;
        std::swap(state.gradient, gradient);
        accepted = true;
      }
    }
    if (!accepted) break;
    measure(state);
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
