// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settled_design.hpp"

#include <algorithm>

#include "curveups/contact/settling.hpp"
#include "curveups/core/checkpoint.hpp"

namespace curveups {
namespace {

void describe(const Settling& settling, const Design& design, SettledDesign& out) {
  out.converged = settling.at_rest();
  out.failure = settling.failure();
  if (settling.is_known()) out.holds = !out.failure;
  out.friction_coefficient = design.parameters.friction_coefficient;
  out.hold_tolerance = hold_tolerance(design.parameters);
  out.contact_force = settling.contact_force();
  out.open_contacts = settling.open_contacts();
  if (out.contact_force.size() > 0) {
    out.normal_mean = out.contact_force.mean();
    out.normal_min = out.contact_force.minCoeff();
  }
  for (const TouchForce& force : settling.tile_world().world->forces()) {
    if (force.push > 0) out.largest_slip = std::max(out.largest_slip, force.slip);
  }
  out.drift = settling.drift();
  const TriangleMesh scanned = settling.surface();
  const Eigen::VectorXd far = scan_distances(scanned, ClosestPoints(design.mesh));
  out.scan = describe_scan(far, scanned, design.mesh);
  out.corners = scanned.V;
  const int count = settling.tile_world().tile_count;
  out.deviation = triangle_means(far);
  out.poses.resize(count, 7);
  for (int i = 0; i < count; ++i) {
    const RigidMotion& pose = settling.tile_world().world->poses()[i];
    const Eigen::Quaterniond turn(pose.R);
    out.poses.row(i) << pose.t.transpose() - settling.centres().row(i), turn.coeffs().transpose();
  }
  out.element_change = settling.element_change();
  out.iterations = settling.iterations();
  out.factorizations = settling.factorizations();
}

}  // namespace

SettledDesign settle_design(const Design& design, const Progress& progress,
                            const SolvedHandle& solved_before) {
  const ProgressScope scope(progress);
  const Parameters& parameters = design.parameters;
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved =
      solved_before ? *solved_before : solve_design(bodies.geometry, design, progress);
  solved.design = design;
  checkpoint("settle", 0);
  SettledDesign out;
  out.margin = find_margin(solved, bodies.geometry, progress);
  out.friction_needed = find_friction_needed(solved, bodies.geometry, progress);
  const WindowSample sample = [&](const std::array<double, 2>& pull, double friction) {
    Settling settling(bodies, solved, pull);
    settling.settle(friction);
    return settling.failure();
  };
  const double mu = parameters.friction_coefficient;
  // Before the elements of `solved` move along with the tiles.
  if (parameters.window && !sample({1, 1}, mu)) out.window = process_window(mu, sample);
  Settling settling(bodies, solved);
  settling.settle(mu, &solved);
  describe(settling, design, out);
  if (!out.holds.value_or(false)) out.window.clear();
  if (!out.window.empty()) out.holding_friction = out.window.back().end[0].value;
  return out;
}

}  // namespace curveups
