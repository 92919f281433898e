// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/design/flat_rim.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

using Membranes = std::array<MembraneSolution, 2>;

MembranePicture picture_of(const MembraneSolution& m) {
  MembranePicture picture{m.flat, m.state.x, {}, {}, {}};
  picture.triangles.resize(m.mesh.triangles.size(), 3);
  picture.stretch.resize(m.mesh.triangles.size(), 2);
  for (std::size_t t = 0; t < m.mesh.triangles.size(); ++t) {
    const auto [a, b, c] = m.mesh.triangles[t];
    picture.triangles.row(t) << a, b, c;
    picture.stretch.row(t) << m.stretch[t].larger, m.stretch[t].smaller;
    picture.tension.push_back(static_cast<int>(m.stretch[t].tension));
  }
  return picture;
}

// Returns per side the tiles beside slack membrane.
std::array<std::vector<int>, 2> describe_membranes(const Membranes& membranes,
                                                   const Points3& centres, double L,
                                                   VerificationReport& report) {
  PhysicsFigures& f = report.physics;
  f.converged = true;
  MembraneAreas both;
  std::array<std::vector<int>, 2> slack_tiles;
  for (int s = 0; s < 2; ++s) {
    const MembraneSolution& m = membranes[s];
    f.triangles += static_cast<int>(m.mesh.triangles.size());
    f.free_vertices += m.free_vertices;
    f.coarse_iterations[s] = m.coarse.state.solve.iterations;
    f.fine_iterations[s] = m.state.solve.iterations;
    f.residual = std::max(f.residual, m.state.solve.residual);
    f.converged = f.converged && m.state.solve.converged() && m.coarse.state.solve.converged();
    for (const TriangleStretch& stretch : m.stretch) {
      f.largest_stretch = std::max(f.largest_stretch, stretch.larger);
    }
    const MembraneAreas areas = measure_areas(m);
    both.all += areas.all;
    both.wrinkled += areas.wrinkled;
    both.slack += areas.slack;
    slack_tiles[s] = tiles_beside_slack(m, areas);
    report.membrane[s] = picture_of(m);
  }
  if (both.all > 0) {
    f.wrinkled_fraction = both.wrinkled / both.all;
    f.slack_fraction = both.slack / both.all;
  }
  f.stretch_99 = stretch_of_all_but(0.01, membranes);
  const WrenchBalance balance = wrench_balance(report.elastic, centres, L);
  f.force_balance = balance.force;
  f.torque_balance = balance.torque;
  f.mean_tile_force = report.elastic.leftCols<3>().rowwise().norm().mean();
  return slack_tiles;
}

void describe_contacts(const TileMesh& tiles, const BalanceSystem& system,
                       const ContactForces& forces, double f_min, VerificationReport& report) {
  ContactFigures& f = report.contact_forces;
  f.f_min = f_min;
  f.normal_mean = forces.normal_mean;
  f.normal_min = forces.normal_min;
  f.imbalance = forces.imbalance;
  const int contacts = static_cast<int>(tiles.contacts.size());
  const double none = std::numeric_limits<double>::quiet_NaN();
  report.contact_normal_min.setConstant(contacts, none);
  report.contact_normal_mean.setConstant(contacts, none);
  report.contact_friction_ratio.setConstant(contacts, none);
  report.tile_normal_min.setConstant(tiles.tile_count(), none);
  report.contact_tiles = contact_tiles(tiles);
  const std::vector<ContactSummary> summaries = summarize_contacts(system, forces.force);
  for (const ContactSummary& one : summaries) {
    report.contact_normal_min(one.contact) = one.normal_min;
    report.contact_normal_mean(one.contact) = one.normal_mean;
    report.contact_friction_ratio(one.contact) = one.friction_ratio;
    f.friction_ratio_mean += one.friction_ratio / static_cast<double>(summaries.size());
    f.friction_ratio_max = std::max(f.friction_ratio_max, one.friction_ratio);
    if (!presses(one.normal_min, f.f_min))
      f.invalid_contacts.push_back(tiles.contacts[one.contact].tile);
    for (int tile : tiles.contacts[one.contact].tile) {
      double& least = report.tile_normal_min(tile);
      if (!(least <= one.normal_min)) least = one.normal_min;
    }
  }
  f.points = system.point_count();
  for (int p = 0; p < f.points; ++p) {
    f.points_below_f_min += !presses(forces.force(p, 0), f.f_min);
    f.pulling_points += forces.force(p, 0) < 0;
  }
}

bool is_feasible(const SolvedDesign& solved, const UnilateralResult& unilateral, double f_min) {
  return unilateral.solve.status == SolveStatus::converged &&
         floor_is_reached(unilateral.largest_floor, f_min, force_scale(solved));
}

// The unilateral problem at bumps' tips, which the verdict does not depend on.
bool is_feasible_at_tips(const SolvedDesign& solved, const DesignGeometry& geometry,
                         const std::vector<Points3>& tips, double f_min, const Progress& progress) {
  const Parameters& parameters = solved.design.parameters;
  BalanceSystem system = make_balance_system(
      geometry, parameters, points_at_tips(contact_corners(geometry, parameters), tips));
  const Points3 start = solve_contact_forces(system, solved.loads).force;
  const UnilateralOptions options = {parameters.friction_coefficient, force_scale(solved)};
  return is_feasible(solved, solve_unilateral(system, solved.loads, start, options, progress),
                     f_min);
}

// Pairs of tiles between which the front or the back sheet would lie on itself.
std::vector<std::array<int, 2>> crossing_sheets(const TileMesh& tiles, const Design& design) {
  const FlatPoses poses = fit_poses(tiles, design.T);
  std::vector<std::array<int, 2>> out;
  for (const Side side : {Side::front, Side::back}) {
    const auto found = crossing_rims(tiles, flat_pin_corners(tiles, poses, design.q, side));
    out.insert(out.end(), found.begin(), found.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

std::vector<ContactPoint> points_at_tips(const std::vector<ContactPoint>& corners,
                                         const std::vector<Points3>& tips) {
  std::vector<ContactPoint> out;
  int last = -1;
  for (const ContactPoint& corner : corners) {
    const Points3& apexes = tips[corner.contact];
    if (apexes.rows() == 0) out.push_back(corner);
    if (corner.contact == last) continue;
    last = corner.contact;
    for (int p = 0; p < apexes.rows(); ++p) {
      out.push_back({apexes.row(p).transpose(), corner.normal, corner.tile, corner.contact});
    }
  }
  return out;
}

VerificationReport verify_design(const Design& design, const Progress& progress,
                                 const VerificationOptions& options) {
  const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  SolvedHandle solved;
  try {
    solved = std::make_shared<const SolvedDesign>(solve_design(geometry, design, progress));
  } catch (const InfeasibleDesign& error) {
    VerificationReport report;
    report.reasons.push_back(
        {"not_laid_out", error.tiles(), {{"said", std::string(error.what())}}});
    return report;
  }
  return verify_solved(geometry, solved, progress, options);
}

VerificationReport verify_solved(const DesignGeometry& geometry, const SolvedHandle& handle,
                                 const Progress& progress, const VerificationOptions& options) {
  const SolvedDesign& solved = *handle;
  const Design& design = solved.design;
  const Parameters& parameters = design.parameters;
  const TileMesh& tiles = geometry.tiles;
  const BumpPlan plan = plan_bumps(geometry, fit_poses(tiles, design.T), parameters);
  VerificationReport report;
  report.computed = true;
  report.solved = handle;
  report.elastic = solved.elastic;
  report.physics.normal_force_error = solved.normal_force_error;
  report.physics.largest_normal_force_error = solved.largest_normal_force_error;
  report.physics.least_force_error = solved.least_force_error;
  report.physics.refined_tiles = static_cast<int>(std::count_if(
      solved.halvings.begin(), solved.halvings.end(), [](int halvings) { return halvings > 0; }));
  const std::array<std::vector<int>, 2> slack_tiles =
      describe_membranes(solved.membranes, tile_centres(tiles), parameters.L, report);

  const GlueLoads glue = glue_loads(tiles, design.q, solved.membranes, parameters);
  report.glue = largest_of(glue);
  report.overloaded_tiles = overloaded_tiles(glue);

  const ContactForces& forces = solved.forces;
  const double f_min = solved.f_min_ratio * std::max(0.0, forces.normal_mean);
  BalanceSystem system = make_balance_system(geometry, parameters);
  describe_contacts(tiles, system, forces, f_min, report);
  if (options.weak_is_enough && report.contact_forces.points_below_f_min > 0) {
    report.complete = false;
    return report;
  }

  const std::vector<Points3> tips = bump_tips(plan, tiles);
  const bool any_tips = std::any_of(tips.begin(), tips.end(),
                                    [](const Points3& apexes) { return apexes.rows() > 0; });
  std::array<MembraneClearance, 2> clearance;
  UnilateralFigures& unilateral = report.unilateral;
  const Progress serial = one_at_a_time(progress);
  auto find_clearance = [&](Side side) {
    const int s = static_cast<int>(side);
    clearance[s] = least_clearance(
        patch_clearances(geometry, solved.membranes[s], parameters.H_pin), parameters.H_pin);
  };
  UnilateralResult at_corners;
  parallel_tasks({[&] { at_corners = find_floor(solved, system, serial); },
                  [&] {
                    if (!any_tips) return;
                    unilateral.feasible_at_tips =
                        is_feasible_at_tips(solved, geometry, tips, f_min, serial);
                  },
                  [&] { find_clearance(Side::front); }, [&] { find_clearance(Side::back); }});
  report.physics.clearance_mm = std::min(clearance[0].distance, clearance[1].distance);
  unilateral.friction_coefficient = parameters.friction_coefficient;
  unilateral.floor = f_min;
  unilateral.status = at_corners.solve.status;
  unilateral.largest_floor = at_corners.largest_floor;
  unilateral.feasible = is_feasible(solved, at_corners, f_min);
  if (parameters.bumps == "dimples") unilateral.sliding_play = sliding_play(plan, tiles);
  give_verdict({solved, at_corners, system, clearance, slack_tiles, crossing_sheets(tiles, design)},
               report);
  return report;
}

}  // namespace curveups
