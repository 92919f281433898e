// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/core/errors.hpp"

namespace curveups {

namespace {
constexpr double jacobi_damping = 0.6;
// Steps by an older factorization that cost about as much as one by a new one.
constexpr int most_reuses = 3;
}  // namespace

bool MembraneEquilibrium::factorize(const Points3& x, Points3& gradient) {
  energy_.hessian(x, gradient, hessian_, false);
  if (factor_.factorize(hessian_)) return true;
  // Only the plain density can be indefinite; its projection is not, but for rounding.
  energy_.hessian(x, gradient, hessian_, true);
  const double shift = 1e-8 * hessian_.diagonal().mean();
  for (int i = 0; i < hessian_.cols(); ++i)
    hessian_.valuePtr()[hessian_.outerIndexPtr()[i]] += shift;
  return factor_.factorize(hessian_);
}

bool MembraneEquilibrium::direction(const Points3& gradient, Points3& out) const {
  const std::vector<int>& index = energy_.free_index();
  Eigen::MatrixXd rhs(3 * energy_.free_count(), 1);
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] >= 0) rhs.block<3, 1>(3 * index[v], 0) = -gradient.row(v).transpose();
  }
  const Eigen::MatrixXd step = factor_.solve(rhs);
  out.setZero(gradient.rows(), 3);
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] >= 0) out.row(v) = step.block<3, 1>(3 * index[v], 0).transpose();
  }
  return step.allFinite();
}

MembraneState MembraneEquilibrium::solve(const Points3& start, const EquilibriumOptions& options,
                                         const Progress& progress, const std::string& what) {
  const std::vector<int>& index = energy_.free_index();
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
  auto measure = [&] {
    double largest = 0, glued = 0;
    int count = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
      const double force = state.gradient.row(v).norm();
      if (index[v] >= 0) {
        largest = std::max(largest, force);
      } else {
        glued += force;
        ++count;
      }
    }
    state.solve.residual = glued > 0 ? largest / (glued / count) : largest;
    if (state.solve.residual <= options.tolerance) state.solve.status = SolveStatus::converged;
  };
  measure();
  if (energy_.free_count() == 0) return state;
  double reduction = 1;  // of the residual by the last step
  while (!state.solve.converged() && state.solve.iterations < options.max_iterations) {
    if (!keep_going(progress, what)) {
      state.solve.status = SolveStatus::stopped;
      break;
    }
    const bool reuse = options.reuse_factor && reduction <= 0.1 &&
                       state.solve.residual * std::pow(reduction, most_reuses) <= options.tolerance;
    if (!reuse && !factorize(state.x, gradient)) break;
    if (!direction(state.gradient, step)) break;
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
    if (!accepted && !reuse) break;
    const double before = state.solve.residual;
    measure();
    reduction = accepted ? state.solve.residual / before : 1;
  }
  return state;
}

void MembraneEquilibrium::respond(const Points3& x, std::vector<Points3>& displacements) const {
  const std::vector<int>& index = energy_.free_index();
  if (energy_.free_count() == 0 || displacements.empty()) return;
  const int count = static_cast<int>(displacements.size());
  for (Points3& d : displacements) {
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] >= 0) d.row(v).setZero();
    }
  }
  std::vector<Points3> forces;
  energy_.second_derivatives(x, displacements, forces, nullptr);
  Eigen::MatrixXd rhs(3 * energy_.free_count(), count);
  for (int k = 0; k < count; ++k) {
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] >= 0) rhs.block<3, 1>(3 * index[v], k) = -forces[k].row(v).transpose();
    }
  }
  const Eigen::MatrixXd response = factor_.solve(rhs);
  for (int k = 0; k < count; ++k) {
    for (std::size_t v = 0; v < index.size(); ++v) {
      if (index[v] >= 0)
        displacements[k].row(v) = response.block<3, 1>(3 * index[v], k).transpose();
    }
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
