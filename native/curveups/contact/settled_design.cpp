// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/contact/settled_design.hpp"

#include <algorithm>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

void describe(const Settling& settling, const TileMesh& tiles, const Design& design,
              SettledDesign& out) {
  out.converged = settling.at_rest();
  out.failure = settling.failure();
  if (settling.is_known()) out.holds = !out.failure;
  out.friction_coefficient = settling.friction();
  out.hold_tolerance = settling.hold_tolerance();
  out.contact_force = settling.contact_force();
  out.open_contacts = settling.open_contacts();
  if (out.contact_force.size() > 0) {
    out.normal_mean = out.contact_force.mean();
    out.normal_min = out.contact_force.minCoeff();
  }
  for (const TouchForce& force : settling.world().forces()) {
    if (force.push > 0) out.largest_slip = std::max(out.largest_slip, force.slip);
  }
  out.drift = settling.drift();
  const TriangleMesh scanned = settling.surface();
  const Eigen::VectorXd far = scan_distances(scanned, ClosestPoints(design.mesh));
  out.scan = describe_scan(far, scanned, design.mesh);
  out.corners = scanned.V;
  const int count = tiles.tile_count();
  out.deviation = triangle_means(far);
  out.poses.resize(count, 7);
  for (int i = 0; i < count; ++i) {
    const RigidMotion& pose = settling.world().poses()[i];
    const Eigen::Quaterniond turn(pose.R);
    out.poses.row(i) << pose.t.transpose() - settling.centres().row(i), turn.coeffs().transpose();
  }
  out.element_change = settling.element_change();
  out.iterations = settling.iterations();
  out.factorizations = settling.factorizations();
}

}  // namespace

SettledDesign settle_design(const Design& design, const Progress& progress) {
  const ProgressScope scope(progress);
  const TileBodies bodies = make_tile_bodies(design);
  SolvedDesign solved = solve_design(bodies.geometry, design, progress);
  checkpoint("settle", 0);
  Settling settling(design, bodies, solved);
  settling.settle({}, design.parameters.friction_coefficient, &solved);
  SettledDesign out;
  describe(settling, bodies.geometry.tiles, design, out);
  // What follows starts from there, at once where there are threads.
  parallel_tasks({[&] {
                    if (!settling.holds()) return;
                    out.holding_friction =
                        holding_friction(settling, design.parameters.window ? window_halvings : 0);
                  },
                  [&] { out.margin = find_margin(settling, design.parameters); }});
  if (design.parameters.window && out.holding_friction) {
    out.window = process_window(settling, *out.holding_friction,
                                largest_of(glue_loads(bodies.geometry.tiles, design.q,
                                                      solved.membranes, design.parameters)));
  }
  return out;
}

}  // namespace curveups
