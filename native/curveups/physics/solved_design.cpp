// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/solved_design.hpp"

#include <algorithm>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

// How often the mesh is refined around undecided points.
constexpr int most_halvings = 2;

Wrenches sum_wrenches(const std::array<MembraneSolution, 2>& membranes, const Points3& centres,
                      Points3 MembraneSolution::*forces) {
  Wrenches wrenches = Wrenches::Zero(centres.rows(), 6);
  for (const MembraneSolution& side : membranes) {
    add_wrenches(side.*forces, side.pin_corners, centres, wrenches);
  }
  return wrenches;
}

// Half of what the extrapolation changes: on the designs it was compared with finer meshes on, the
// extrapolated normal forces were within a fifth of it. Returns the error of each point, N.
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

// Points that exceed f_min by less than their error, where all push as hard as is asked for. f_min
// itself may be larger than that by the error.
std::vector<int> undecided_points(const SolvedDesign& solved, const Eigen::ArrayXd& error) {
  std::vector<int> out;
  const double asked = solved.design.parameters.f_min_ratio * solved.forces.normal_mean,
               f_min = solved.f_min_ratio * solved.forces.normal_mean;
  if (error.size() == 0 || solved.forces.normal_min < asked) return out;
  for (int p = 0; p < error.size(); ++p) {
    if (solved.forces.force(p, 0) - error(p) < f_min) out.push_back(p);
  }
  return out;
}

// The tiles of these contacts and all that touch them: the membranes around these decide on most of
// a point's force.
std::vector<int> tiles_around(const TileMesh& tiles, const std::vector<std::array<int, 2>>& pairs) {
  std::vector<char> at(tiles.tile_count(), 0), around = at;
  for (const std::array<int, 2>& pair : pairs) at[pair[0]] = at[pair[1]] = 1;
  for (const Contact& contact : tiles.contacts) {
    const auto [a, b] = contact.tile;
    if (at[a] || at[b]) around[a] = around[b] = 1;
  }
  std::vector<int> out;
  for (int i = 0; i < tiles.tile_count(); ++i) {
    if (around[i]) out.push_back(i);
  }
  return out;
}

SolvedDesign solve_on_mesh(const DesignGeometry& geometry, const Design& design,
                           const Progress& progress, const std::vector<int>& halvings) {
  const Parameters& parameters = design.parameters;
  SolvedDesign solved;
  solved.design = design;
  solved.halvings = halvings;
  const FlatPoses poses = fit_poses(geometry.tiles, design.T);
  solved.membranes = solve_membranes(geometry, poses, design.q, parameters, progress, halvings);
  const Points3 centres = tile_centres(geometry.tiles);
  const Wrenches fine = sum_wrenches(solved.membranes, centres, &MembraneSolution::forces);
  solved.elastic = extrapolate<Wrenches>(
      fine, sum_wrenches(solved.membranes, centres, &MembraneSolution::coarse_forces));
  const Wrenches weight = weights(geometry, poses, design.q, parameters);
  solved.carried = carry(geometry, weight, parameters);
  const Wrenches others = weight + solved.carried.table;
  solved.loads = solved.elastic + others;
  BalanceSystem system = make_balance_system(geometry, parameters);
  solved.forces = solve_contact_forces(system, solved.loads);
  const Eigen::ArrayXd error =
      estimate_error(solve_contact_forces(system, fine + others).force, solved);
  solved.f_min_ratio =
      std::max({parameters.f_min_ratio, solved.normal_force_error, solved.least_force_error});
  for (int point : undecided_points(solved, error)) {
    const std::array<int, 2>& pair = system.points()[point].tile;
    if (solved.undecided.empty() || solved.undecided.back() != pair) {
      solved.undecided.push_back(pair);
    }
  }
  return solved;
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
  SolvedDesign solved = solve_on_mesh(geometry, design, progress, {});
  for (int round = 0; round < most_halvings && !solved.undecided.empty(); ++round) {
    std::vector<int> halvings = solved.halvings;
    halvings.resize(geometry.tiles.tile_count(), 0);
    for (int tile : tiles_around(geometry.tiles, solved.undecided)) ++halvings[tile];
    try {
      solved = solve_on_mesh(geometry, design, progress, halvings);
    } catch (const InvalidInput&) {  // too many triangles: it stays undecided
      break;
    }
  }
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
