// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/friction_needed.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "curveups/core/sort_unique.hpp"
#include "curveups/numerics/cone_program.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

constexpr int most_programs = 12, most_named_points = 20;
constexpr double accuracy = 0.005;

std::vector<int> tiles_at(const std::vector<ContactPoint>& points, const Eigen::VectorXd& weight) {
  std::vector<int> order(weight.size()), tiles;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return weight(a) > weight(b); });
  const double least = 0.01 * weight.maxCoeff();
  for (std::size_t k = 0; k < order.size() && k < most_named_points; ++k) {
    if (weight(order[k]) < least) break;
    for (int tile : points[order[k]].tile) tiles.push_back(tile);
  }
  sort_unique(tiles);
  return tiles;
}

}  // namespace

FrictionNeeded find_friction_needed(const SolvedDesign& solved, const DesignGeometry& geometry,
                                    const Progress& progress) {
  FrictionNeeded out;
  BalanceSystem system = make_balance_system(geometry, solved.design.parameters);
  const int count = system.point_count();
  if (count == 0) return out;
  const double scale = force_scale(solved);
  const Eigen::VectorXd b = system.restrict(solved.loads) / scale;
  Eigen::VectorXd force =
      Eigen::Map<const Eigen::VectorXd>(solved.forces.force.data(), 3 * count) / scale;
  ConeOptions options;
  options.floor = solved.f_min() / scale;
  double mu = solved.design.parameters.friction_coefficient;
  options.friction = true;
  for (int k = 0; k < most_programs && mu > 0; ++k) {
    options.friction_coefficient = mu;
    const ConeSolution solution = solve_cone_program(system, b, force, options, progress);
    if (!solution.solve.converged()) break;
    force = solution.force;
    const Eigen::VectorXd rest = system.apply(force) + b;
    if (rest.size() > 0 && !(rest.cwiseAbs().maxCoeff() < 1e-6)) break;
    double needed = 0, slope = 0;
    for (int p = 0; p < count; ++p) {
      const Vec3 f = force.segment<3>(3 * p);
      if (!(f.x() > 0)) return out;
      needed = std::max(needed, f.tail<2>().norm() / f.x());
      slope += solution.circle(p, 0) * f.x();
    }
    if (!out.coefficient || needed < *out.coefficient) {
      out.coefficient = needed;
      out.tiles = tiles_at(system.points(), solution.circle.col(0));
    }
    const double next = mu - solution.s / slope;
    if (!(slope > 0) || *out.coefficient - next < accuracy) break;
    mu = std::max(next, 0.1 * mu);
  }
  return out;
}

}  // namespace curveups
