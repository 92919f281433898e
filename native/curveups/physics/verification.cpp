// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/bodies/bumps.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/sort_unique.hpp"
#include "curveups/design/flat_rim.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

MembranePicture picture_of(const MembraneSolution& m) {
  const std::vector<std::array<int, 3>>& triangles = m.fine.mesh.triangles;
  MembranePicture picture{m.fine.flat(), m.fine.state.x, {}, {}, {}};
  picture.triangles.resize(triangles.size(), 3);
  picture.stretch.resize(triangles.size(), 2);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    picture.triangles.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
    picture.stretch.row(t) << m.stretch[t].larger, m.stretch[t].smaller;
    picture.tension.push_back(static_cast<int>(m.stretch[t].tension));
  }
  return picture;
}

void describe_membranes(const SolvedDesign& solved, const Points3& centres, double L,
                        VerificationReport& report) {
  PhysicsFigures& f = report.physics;
  f.converged = true;
  for (int s = 0; s < 2; ++s) {
    const SolvedMembrane &coarse = solved.membranes[s].coarse, &fine = solved.membranes[s].fine;
    f.triangles += static_cast<int>(fine.mesh.triangles.size());
    f.free_vertices += static_cast<int>(std::count(fine.mesh.pin.begin(), fine.mesh.pin.end(), -1));
    f.coarse_iterations[s] = coarse.state.solve.iterations;
    f.fine_iterations[s] = fine.state.solve.iterations;
    f.residual = std::max(f.residual, fine.state.solve.residual);
    f.converged = f.converged && fine.state.solve.converged() && coarse.state.solve.converged();
    report.membrane[s] = picture_of(solved.membranes[s]);
  }
  f.wrinkled_fraction = wrinkled_fraction(solved.membranes);
  f.stretch_99 = stretch_of_all_but(0.01, solved.membranes);
  const WrenchBalance balance = wrench_balance(solved.elastic, centres, L);
  f.force_balance = balance.force;
  f.torque_balance = balance.torque;
  f.normal_force_error = solved.normal_force_error;
  f.largest_normal_force_error = solved.largest_normal_force_error;
  f.least_force_error = solved.least_force_error;
  f.mean_tile_force = solved.elastic.leftCols<3>().rowwise().norm().mean();
}

void describe_contacts(const TileMesh& tiles, const BalanceSystem& system,
                       const SolvedDesign& solved, VerificationReport& report) {
  const ContactForces& forces = solved.forces;
  ContactFigures& f = report.contact_forces;
  f.f_min = solved.f_min();
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
  f.points = system.point_count();
  int loaded = 0;  // contacts with points
  for (int p = 0; p < f.points; ++loaded) {
    const int contact = system.points()[p].contact;
    const std::array<int, 2>& pair = tiles.contacts[contact].tile;
    double normal = 0, least = std::numeric_limits<double>::infinity();
    Vec3 tangential = Vec3::Zero();
    int count = 0;
    for (; p < f.points && system.points()[p].contact == contact; ++p, ++count) {
      const Vec3 force = forces.force.row(p);
      normal += force.x();
      least = std::min(least, force.x());
      tangential += system.basis(p).rightCols<2>() * force.tail<2>();
      f.points_below_f_min += !presses(force.x(), f.f_min);
      f.pulling_points += force.x() < 0;
    }
    const double ratio = tangential.norm() / std::max(std::abs(normal), 1e-300);
    report.contact_normal_min(contact) = least;
    report.contact_normal_mean(contact) = normal / count;
    report.contact_friction_ratio(contact) = ratio;
    f.friction_ratio_mean += ratio;
    f.friction_ratio_max = std::max(f.friction_ratio_max, ratio);
    if (!presses(least, f.f_min)) f.invalid_contacts.push_back(pair);
    for (int tile : pair) {
      double& of_tile = report.tile_normal_min(tile);
      if (!(of_tile <= least)) of_tile = least;
    }
  }
  if (loaded > 0) f.friction_ratio_mean /= loaded;
}

bool is_feasible(const SolvedDesign& solved, const UnilateralResult& unilateral) {
  return unilateral.solve.converged() &&
         floor_is_reached(unilateral.largest_floor, solved.f_min(), force_scale(solved));
}

// The unilateral problem at bumps' tips, which the verdict does not depend on.
bool is_feasible_at_tips(const SolvedDesign& solved, const DesignGeometry& geometry,
                         const std::vector<Points3>& tips, const Progress& progress) {
  const Parameters& parameters = solved.design.parameters;
  BalanceSystem system = make_balance_system(
      geometry, parameters, points_at_tips(contact_corners(geometry, parameters), tips));
  const Points3 start = solve_contact_forces(system, solved.loads).force;
  const UnilateralOptions options = {parameters.friction_coefficient, force_scale(solved)};
  return is_feasible(solved, solve_unilateral(system, solved.loads, start, options, progress));
}

// Pairs of tiles between which the front or the back sheet would lie on itself.
std::vector<std::array<int, 2>> crossing_sheets(const TileMesh& tiles, const Design& design) {
  const FlatPoses poses = fit_poses(tiles, design.T);
  std::vector<std::array<int, 2>> out;
  for (const Side side : {Side::front, Side::back}) {
    const auto pairs = crossing_rims(tiles, flat_pin_corners(tiles, poses, design.q, side));
    out.insert(out.end(), pairs.begin(), pairs.end());
  }
  sort_unique(out);
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
  report.glue = glue_figures(tiles, design.q, solved.membranes, parameters);
  describe_membranes(solved, tile_centres(tiles), parameters.L, report);
  BalanceSystem system = make_balance_system(geometry, parameters);
  describe_contacts(tiles, system, solved, report);
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
  UnilateralResult at_corners;
  parallel_for(4, [&](int task) {
    if (task == 0) {
      at_corners = find_floor(solved, system, serial);
    } else if (task == 1) {
      if (any_tips) {
        unilateral.feasible_at_tips = is_feasible_at_tips(solved, geometry, tips, serial);
      }
    } else {
      const int s = task - 2;
      clearance[s] = least_clearance(
          patch_clearances(geometry, solved.membranes[s], parameters.H_pin), parameters.H_pin);
    }
  });
  report.physics.clearance_mm = std::min(clearance[0].distance, clearance[1].distance);
  unilateral.friction_coefficient = parameters.friction_coefficient;
  unilateral.floor = solved.f_min();
  unilateral.status = at_corners.solve.status;
  unilateral.largest_floor = at_corners.largest_floor;
  unilateral.feasible = is_feasible(solved, at_corners);
  if (parameters.bumps == "dimples") unilateral.sliding_play = sliding_play(plan, tiles);
  give_verdict({solved, at_corners, system, clearance, crossing_sheets(tiles, design)}, report);
  return report;
}

}  // namespace curveups
