// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/margin.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

// Failure of the verdict on pushing forces, if any.
std::optional<Finding> failure_of(const UnilateralResult& result, const BalanceSystem& system,
                                  double f_min, double scale) {
  if (result.solve.status == SolveStatus::unfinished) return Finding{"margin.unknown"};
  if (result.solve.converged() && floor_is_reached(result.largest_floor, f_min, scale)) {
    return std::nullopt;
  }
  const Finding::Pairs contacts = critical_contacts(result, system);
  return Finding{result.solve.converged() ? "margin" : "margin.no_balance",
                 tiles_of(contacts),
                 {{"least", result.largest_floor},
                  {"pull", -result.largest_floor},
                  {"f_min", f_min},
                  {"contacts", contacts}}};
}

}  // namespace

Margin find_margin(const SolvedDesign& solved, const DesignGeometry& geometry,
                   const Progress& progress) {
  const Parameters& p = solved.design.parameters;
  Margin out;
  out.mode = p.margin;
  out.mismatch = p.margin_mismatch;
  out.friction_coefficient = p.margin_friction;
  if (out.mode == "off") return out;
  const Points3 centres = tile_centres(geometry.tiles);
  const double f_min = solved.f_min();
  UnilateralOptions options;
  options.friction_coefficient = std::min(p.margin_friction, p.friction_coefficient);
  options.scale = force_scale(solved);
  const Progress serial = one_at_a_time(progress);
  parallel_for(2, [&](int s) {
    BalanceSystem system = make_balance_system(geometry, p);
    const Wrenches loads =
        solved.loads + out.mismatch / 100 * extrapolated_wrenches(solved.membranes[s], centres);
    const Points3 start = solve_contact_forces(system, loads).force;
    const UnilateralResult result = solve_unilateral(system, loads, start, options, serial);
    out.failure[s] = failure_of(result, system, f_min, options.scale);
    if (out.failure[s]) {
      out.failure[s]->figures["side"] = side_name(static_cast<Side>(s));
      out.failure[s]->figures["percent"] = out.mismatch;
      out.failure[s]->figures["mu"] = options.friction_coefficient;
    }
  });
  const auto is_unknown = [](const Finding& f) { return f.kind == "margin.unknown"; };
  out.met = true;
  for (const std::optional<Finding>& f : out.failure) {
    if (f && is_unknown(*f)) out.met.reset();
  }
  for (const std::optional<Finding>& f : out.failure) {
    if (f && !is_unknown(*f)) out.met = false;
  }
  return out;
}

}  // namespace curveups
