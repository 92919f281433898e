// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/unilateral.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "curveups/numerics/cone_program.hpp"

namespace curveups {
namespace {

using Eigen::VectorXd;

std::vector<int> heaviest(const VectorXd& weight) {
  std::vector<int> order(weight.size());
  std::iota(order.begin(), order.end(), 0);
  const std::size_t keep = std::min<std::size_t>(20, order.size());
  std::partial_sort(order.begin(), order.begin() + keep, order.end(), [&](int a, int b) {
    return weight(a) != weight(b) ? weight(a) > weight(b) : a < b;
  });
  order.resize(keep);
  return order;
}

// The cones' slacks are (mu n . F, F - (n . F) n) and n . F - s, F the force at the point.
Points3 derivative_by_normals(const BalanceSystem& system, double mu, const Points3& circle,
                              const VectorXd& floor, const Points3& force) {
  Points3 out(force.rows(), 3);
  for (int p = 0; p < force.rows(); ++p) {
    const Eigen::Matrix3d& basis = system.basis(p);
    const double along = floor(p) + mu * circle(p, 0);
    const Vec3 sideways = circle(p, 1) * basis.col(1) + circle(p, 2) * basis.col(2);
    const Vec3 F = basis * force.row(p).transpose();
    out.row(p) = (along * F - force(p, 0) * sideways).transpose();
  }
  return out;
}

}  // namespace

std::vector<std::array<int, 2>> critical_contacts(const UnilateralResult& result,
                                                  const BalanceSystem& system) {
  std::vector<std::array<int, 2>> pairs;
  for (int point : result.critical_points) {
    const std::array<int, 2>& pair = system.points()[point].tile;
    if (std::find(pairs.begin(), pairs.end(), pair) != pairs.end()) continue;
    pairs.push_back(pair);
    if (pairs.size() == 4) break;
  }
  return pairs;
}

UnilateralResult solve_unilateral(BalanceSystem& system, const Wrenches& loads,
                                  const Points3& start, const UnilateralOptions& options,
                                  const Progress& progress) {
  UnilateralResult result;
  const int count = system.point_count();
  const double mu = options.friction_coefficient;
  result.force = start;
  const VectorXd b = system.restrict(loads) / options.scale;
  if (count == 0) {
    const bool balanced = b.size() == 0 || b.cwiseAbs().maxCoeff() < options.tolerance;
    result.solve.status = balanced ? SolveStatus::converged : SolveStatus::infeasible;
    return result;
  }
  const VectorXd from = Eigen::Map<const VectorXd>(start.data(), start.size()) / options.scale;
  for (bool relaxed : {false, true}) {
    const ConeSolution outcome =
        solve_cone_program(system, b, from, {mu, relaxed, options.tolerance}, progress);
    result.solve.iterations += outcome.solve.iterations;
    if (!outcome.solve.converged()) continue;
    // Certify the forces themselves.
    double floor = 1, slip = 0;
    for (int p = 0; p < count; ++p) {
      const Vec3 f = outcome.force.segment<3>(3 * p);
      floor = std::min(floor, f.x());
      slip = std::max(slip, f.tail<2>().norm() - mu * f.x());
    }
    const VectorXd rest = system.apply(outcome.force) + b;
    const double imbalance = rest.size() ? rest.cwiseAbs().maxCoeff() : 0;
    if (imbalance > 1e-6) continue;
    result.force = options.scale * Eigen::Map<const Points3>(outcome.force.data(), count, 3);
    result.critical_points = heaviest(outcome.weight);
    result.motion = system.expand(outcome.y);
    result.by_normal =
        derivative_by_normals(system, mu, outcome.circle, outcome.floor, result.force);
    if (floor >= -options.tolerance && slip <= options.tolerance) {
      result.solve.status = SolveStatus::converged;
      result.largest_floor = options.scale * std::max(0.0, std::min(floor, 1.0));
      return result;
    }
    // The optimum itself is negative: no forces do without a pull.
    if (outcome.s < -options.tolerance) {
      result.solve.status = SolveStatus::infeasible;
      result.largest_floor = options.scale * outcome.s;
      return result;
    }
  }
  return result;
}

}  // namespace curveups
