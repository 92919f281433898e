// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/solved_design.hpp"

#include <algorithm>
#include <utility>

namespace curveups {
namespace {

// Error of each point's normal force, N: half of the change by extrapolation. Extrapolated forces
// were within a fifth of it where they were compared with those on finer meshes.
Eigen::ArrayXd estimate_error(const Points3& fine_forces, SolvedDesign& solved) {
  const ContactForces& forces = solved.forces;
  const Eigen::ArrayXd force = forces.force.col(0).array();
  Eigen::ArrayXd error = 0.5 * (force - fine_forces.col(0).array()).abs();
  if (error.size() == 0 || !(forces.normal_mean > 0)) return error;
  solved.normal_force_error = error.mean() / forces.normal_mean;
  solved.largest_normal_force_error = error.maxCoeff() / forces.normal_mean;
  solved.least_force_error = error_of_least(force, error) / forces.normal_mean;
  return error;
}

// SolvedDesign::undecided. points: those of the forces.
std::vector<std::array<int, 2>> undecided_contacts(const SolvedDesign& solved,
                                                   const Eigen::ArrayXd& error,
                                                   const std::vector<ContactPoint>& points) {
  std::vector<std::array<int, 2>> out;
  const double least = solved.design.parameters.f_min_ratio * solved.forces.normal_mean,
               f_min = solved.f_min_ratio * solved.forces.normal_mean;
  if (error.size() == 0 || solved.forces.normal_min < least) return out;
  for (int p = 0; p < error.size(); ++p) {
    if (solved.forces.force(p, 0) - error(p) >= f_min) continue;
    if (out.empty() || out.back() != points[p].tile) out.push_back(points[p].tile);
  }
  return out;
}

}  // namespace

double error_of_least(const Eigen::ArrayXd& force, const Eigen::ArrayXd& error) {
  return force.size() > 0 ? force.minCoeff() - (force - error).minCoeff() : 0.0;
}

std::vector<ContactPoint> contact_corners(const DesignGeometry& geometry,
                                          const Parameters& parameters) {
  std::vector<ContactPoint> points = interface_points(geometry.tiles, geometry.patches);
  const std::vector<int> held = held_tiles(geometry, parameters);
  auto is_held = [&](int tile) { return std::binary_search(held.begin(), held.end(), tile); };
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const ContactPoint& point) {
                                return is_held(point.tile[0]) && is_held(point.tile[1]);
                              }),
               points.end());
  return points;
}

BalanceSystem make_balance_system(const DesignGeometry& geometry, const Parameters& parameters,
                                  std::vector<ContactPoint> points) {
  return BalanceSystem(std::move(points), tile_centres(geometry.tiles), parameters.L,
                       held_tiles(geometry, parameters));
}

BalanceSystem make_balance_system(const DesignGeometry& geometry, const Parameters& parameters) {
  return make_balance_system(geometry, parameters, contact_corners(geometry, parameters));
}

SolvedDesign solve_design(const DesignGeometry& geometry, const Design& design,
                          const Progress& progress) {
  const Parameters& parameters = design.parameters;
  SolvedDesign solved;
  solved.design = design;
  solved.membranes = solve_membranes(geometry, fit_poses(geometry.tiles, design.T), design.q,
                                     parameters, progress);
  const Points3 centres = tile_centres(geometry.tiles);
  Wrenches fine = Wrenches::Zero(centres.rows(), 6);
  solved.elastic = fine;
  for (const MembraneSolution& m : solved.membranes) {
    fine += membrane_wrenches(m.fine.mesh, m.fine.state, centres);
    solved.elastic += extrapolated_wrenches(m, centres);
  }
  const Wrenches weight = weights(geometry, design.q, parameters);
  solved.carried = carry(geometry, weight, parameters);
  const Wrenches others = weight + solved.carried.table;
  solved.loads = solved.elastic + others;
  BalanceSystem system = make_balance_system(geometry, parameters);
  solved.forces = solve_contact_forces(system, solved.loads);
  const Eigen::ArrayXd error =
      estimate_error(solve_contact_forces(system, fine + others).force, solved);
  solved.f_min_ratio =
      std::max({parameters.f_min_ratio, solved.normal_force_error, solved.least_force_error});
  solved.undecided = undecided_contacts(solved, error, system.points());
  return solved;
}

double force_scale(const SolvedDesign& solved) {
  if (solved.forces.normal_mean > 0) return solved.forces.normal_mean;
  return std::max(solved.elastic.leftCols<3>().rowwise().norm().mean(), 1e-12);
}

UnilateralResult find_floor(const SolvedDesign& solved, BalanceSystem& system,
                            const Progress& progress) {
  UnilateralOptions options;
  options.friction_coefficient = solved.design.parameters.friction_coefficient;
  options.scale = force_scale(solved);
  return solve_unilateral(system, solved.loads, solved.forces.force, options, progress);
}

}  // namespace curveups
