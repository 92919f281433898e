// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/validation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/physics/clearance.hpp"
#include "curveups/physics/loads.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Membranes = std::array<MembraneSolution, 2>;

void check_arrays(const Design& design, const VerifyOptions& options, const TileMesh& tiles) {
  if (design.T.rows() != tiles.tile_count() || design.q.rows() != tiles.tile_count()) {
    throw InvalidInput("the design's layout and pins do not have one row per tile",
                       "give T and q for every row of F");
  }
  if (!design.T.allFinite() || !design.q.allFinite()) {
    throw InvalidInput("the design holds a number that is not finite", "give finite numbers");
  }
  if (!options.bump_tips.empty() && options.bump_tips.size() != tiles.contacts.size()) {
    throw InvalidInput("bump tips are given for " + std::to_string(options.bump_tips.size()) +
                           " contacts, the design has " + std::to_string(tiles.contacts.size()),
                       "give one array per contact");
  }
  for (const Points3& tips : options.bump_tips) {
    if (!tips.allFinite()) {
      throw InvalidInput("a bump's tip is not finite", "give finite numbers");
    }
  }
}

Wrenches sum_wrenches(const Membranes& membranes, const Points3& centres,
                      Points3 MembraneSolution::*forces) {
  Wrenches wrenches = Wrenches::Zero(centres.rows(), 6);
  for (const MembraneSolution& side : membranes) {
    add_wrenches(side.*forces, side.pin_corners, centres, wrenches);
  }
  return wrenches;
}

void describe_membranes(const Membranes& membranes, const Points3& centres, double L,
                        ValidationReport& report, std::array<std::vector<int>, 2>& slack_tiles) {
  PhysicsFigures& f = report.physics;
  f.converged = true;
  double area = 0, wrinkled = 0, slack = 0;
  for (int s = 0; s < 2; ++s) {
    const MembraneSolution& m = membranes[s];
    f.triangles += static_cast<int>(m.mesh.triangles.size());
    f.free_vertices += m.free_vertices;
    f.coarse_iterations[s] = m.coarse.state.solve.iterations;
    f.fine_iterations[s] = m.state.solve.iterations;
    f.residual = std::max(f.residual, m.state.solve.residual);
    f.converged = f.converged && m.state.solve.converged() && m.coarse.state.solve.converged();
    MembranePicture& picture = report.membrane[s];
    picture.flat = m.flat;
    picture.actuated = m.state.x;
    picture.triangles.resize(m.mesh.triangles.size(), 3);
    picture.stretch.resize(m.mesh.triangles.size(), 2);
    std::vector<double> patch_area(m.domain.patches.size(), 0), patch_slack = patch_area;
    for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
      const auto [a, b, c] = m.mesh.triangles[t];
      const Vec2 p = m.flat.row(a), q = m.flat.row(b), r = m.flat.row(c);
      const double part = wedge(q - p, r - p);
      const TriangleStretch& stretch = m.stretch[t];
      area += part;
      if (stretch.tension != MembraneTension::taut) wrinkled += part;
      patch_area[m.mesh.patch[t]] += part;
      if (stretch.tension == MembraneTension::slack) {
        slack += part;
        patch_slack[m.mesh.patch[t]] += part;
      }
      f.largest_stretch = std::max(f.largest_stretch, stretch.larger);
      picture.triangles.row(t) << a, b, c;
      picture.stretch.row(t) << stretch.larger, stretch.smaller;
      picture.tension.push_back(static_cast<int>(stretch.tension));
    }
    for (std::size_t p = 0; p < patch_area.size(); ++p) {
      if (patch_slack[p] <= 0.1 * patch_area[p]) continue;
      for (int tile : tiles_of(m.domain.patches[p])) slack_tiles[s].push_back(tile);
    }
    std::sort(slack_tiles[s].begin(), slack_tiles[s].end());
    slack_tiles[s].erase(std::unique(slack_tiles[s].begin(), slack_tiles[s].end()),
                         slack_tiles[s].end());
  }
  if (area > 0) {
    f.wrinkled_fraction = wrinkled / area;
    f.slack_fraction = slack / area;
  }
  const WrenchBalance balance = wrench_balance(report.elastic, centres, L);
  f.force_balance = balance.force;
  f.torque_balance = balance.torque;
  f.mean_tile_force = report.elastic.leftCols<3>().rowwise().norm().mean();
}

// Half of what the extrapolation changes: on the designs it was compared with finer meshes on, the
// extrapolated normal forces were within a fifth of it.
void estimate_error(const ContactForces& extrapolated, const ContactForces& fine,
                    ValidationReport& report) {
  const Eigen::ArrayXd error = 0.5 * (extrapolated.force.col(0) - fine.force.col(0)).array().abs();
  if (error.size() == 0 || !(extrapolated.normal_mean > 0)) return;
  report.physics.normal_force_error = error.mean() / extrapolated.normal_mean;
  report.physics.largest_normal_force_error = error.maxCoeff() / extrapolated.normal_mean;
}

void describe_contacts(const TileMesh& tiles, const BalanceSystem& system,
                       const ContactForces& forces, ValidationReport& report) {
  ContactFigures& f = report.contact_forces;
  f.normal_mean = forces.normal_mean;
  f.normal_min = forces.normal_min;
  f.imbalance = forces.imbalance;
  const int contacts = static_cast<int>(tiles.contacts.size());
  const double none = std::numeric_limits<double>::quiet_NaN();
  report.contact_normal_min.setConstant(contacts, none);
  report.contact_normal_mean.setConstant(contacts, none);
  report.contact_friction_ratio.setConstant(contacts, none);
  report.tile_normal_min.setConstant(tiles.tile_count(), none);
  for (const Contact& contact : tiles.contacts) report.contact_tiles.push_back(contact.tile);
  const std::vector<ContactSummary> summaries = summarize_contacts(system, forces.force);
  for (const ContactSummary& one : summaries) {
    report.contact_normal_min(one.contact) = one.normal_min;
    report.contact_normal_mean(one.contact) = one.normal_mean;
    report.contact_friction_ratio(one.contact) = one.friction_ratio;
    f.friction_ratio_mean += one.friction_ratio / static_cast<double>(summaries.size());
    f.friction_ratio_max = std::max(f.friction_ratio_max, one.friction_ratio);
    if (one.normal_min < f.f_min) f.invalid_contacts.push_back(tiles.contacts[one.contact].tile);
    for (int tile : tiles.contacts[one.contact].tile) {
      double& least = report.tile_normal_min(tile);
      if (!(least <= one.normal_min)) least = one.normal_min;
    }
  }
  for (int p = 0; p < system.point_count(); ++p) {
    if (system.points()[p].contact < 0) continue;
    ++f.points;
    f.points_below_f_min += forces.force(p, 0) < f.f_min;
    f.pulling_points += forces.force(p, 0) < 0;
  }
}

std::vector<ContactPoint> tip_points(const TileMesh& tiles, const DesignGeometry& geometry,
                                     const std::vector<Points3>& tips) {
  std::vector<ContactPoint> points;
  for (const ContactPoint& corner : interface_points(tiles, geometry.patches)) {
    const Points3& here = tips[corner.contact];
    if (here.rows() == 0) {
      points.push_back(corner);
    } else if (points.empty() || points.back().contact != corner.contact) {
      for (int p = 0; p < here.rows(); ++p) {
        points.push_back({here.row(p).transpose(), corner.normal, corner.tile, corner.contact});
      }
    }
  }
  return points;
}

}  // namespace

bool SolvedDesign::belongs_to(const Design& design) const {
  return mesh.V == design.mesh.V && mesh.F == design.mesh.F && T == design.T && q == design.q;
}

ValidationReport verify_design(const Design& design, const VerifyOptions& options,
                               const Progress& progress) {
  const Parameters& parameters = design.parameters;
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, parameters);
  const TileMesh& tiles = geometry.tiles;
  check_arrays(design, options, tiles);
  const FlatPoses poses = fit_poses(tiles, design.T);
  ValidationReport report;
  Membranes membranes;
  try {
    membranes = options.solved && options.solved->belongs_to(design)
                    ? std::move(options.solved->membranes)
                    : solve_membranes(geometry, poses, design.q, parameters, progress);
  } catch (const InfeasibleDesign& error) {
    report.reasons.push_back(error.what());
    return report;
  }
  const Points3 centres = tile_centres(tiles);
  report.computed = true;
  const Wrenches fine = sum_wrenches(membranes, centres, &MembraneSolution::forces);
  report.elastic = extrapolate<Wrenches>(
      fine, sum_wrenches(membranes, centres, &MembraneSolution::coarse_forces));
  std::array<std::vector<int>, 2> slack_tiles;
  describe_membranes(membranes, centres, parameters.L, report, slack_tiles);

  const GravityLoad gravity = gravity_load(geometry, parameters);
  const Wrenches loads = report.elastic + gravity.weight;
  auto make_system = [&](std::vector<ContactPoint> points) {
    points.insert(points.end(), gravity.ground.begin(), gravity.ground.end());
    return BalanceSystem(std::move(points), centres, parameters.L, gravity.held);
  };
  const std::vector<ContactPoint> corners = interface_points(tiles, geometry.patches);
  BalanceSystem system = make_system(corners);
  const ContactForces forces = solve_contact_forces(system, loads);
  estimate_error(forces, solve_contact_forces(system, fine + gravity.weight), report);
  const double asked = parameters.f_min_ratio,
               least = std::max(asked, report.physics.normal_force_error);
  const double scale =
      forces.normal_mean > 0 ? forces.normal_mean : std::max(report.physics.mean_tile_force, 1e-12);
  report.contact_forces.f_min = least * std::max(0.0, forces.normal_mean);
  describe_contacts(tiles, system, forces, report);
  // Three second-order cone programs and two clearances, independent of one another.
  UnilateralOptions coulomb_options;
  coulomb_options.friction_coefficient = parameters.friction_coefficient;
  coulomb_options.scale = scale;
  UnilateralOptions unlimited_options = coulomb_options;
  unlimited_options.friction_coefficient = infinity;
  const bool with_tips = std::any_of(options.bump_tips.begin(), options.bump_tips.end(),
                                     [](const Points3& tips) { return tips.rows() > 0; });
  BalanceSystem unlimited_system = make_system(corners);
  BalanceSystem tips_system =
      make_system(with_tips ? tip_points(tiles, geometry, options.bump_tips) : corners);
  UnilateralResult coulomb, unlimited, tips;
  std::array<MembraneClearance, 2> clearance;
  std::mutex mutex;
  const Progress serial = [&](const std::string& what, double fraction) {
    const std::lock_guard<std::mutex> lock(mutex);
    return keep_going(progress, what, fraction);
  };
  auto solve_tips = [&] {
    if (!with_tips) return;
    const ContactForces start = solve_contact_forces(tips_system, loads);
    tips = solve_unilateral(tips_system, loads, start.force, coulomb_options, serial);
  };
  auto find_clearance = [&](int s) {
    clearance[s] = membrane_clearance(geometry, membranes[s], parameters.H_pin);
  };
  parallel_tasks(
      {[&] { coulomb = solve_unilateral(system, loads, forces.force, coulomb_options, serial); },
       solve_tips,
       [&] {
         unlimited =
             solve_unilateral(unlimited_system, loads, forces.force, unlimited_options, serial);
       },
       [&] { find_clearance(0); }, [&] { find_clearance(1); }});
  report.physics.clearance_mm = std::min(clearance[0].distance, clearance[1].distance);
  UnilateralFigures& u = report.unilateral;
  u.friction_coefficient = parameters.friction_coefficient;
  u.floor = report.contact_forces.f_min;
  u.status = coulomb.solve.status;
  u.largest_floor = coulomb.largest_floor;
  u.feasible = coulomb.solve.status == SolveStatus::converged &&
               coulomb.largest_floor >= u.floor - coulomb_options.tolerance * scale;
  u.unlimited_status = unlimited.solve.status;
  u.unlimited_largest_floor = unlimited.largest_floor;
  if (with_tips) {
    u.tips_status = tips.solve.status;
    u.tips_largest_floor = tips.largest_floor;
  }
  give_verdict({tiles, system, forces, coulomb, with_tips ? &tips : nullptr,
                with_tips ? &tips_system : nullptr, clearance, slack_tiles, least > asked},
               report);
  if (options.keep_solution) {
    report.solved = std::make_shared<SolvedDesign>();
    *report.solved = {design.mesh, design.T, design.q, std::move(membranes), loads, least};
  }
  return report;
}

}  // namespace curveups
