// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/margin.hpp"

#include <algorithm>

#include "curveups/core/parallel.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

constexpr std::size_t most_named = 4;  // contacts

// Loads with the membrane of one side pulling `factor` times as hard.
Wrenches scaled_loads(const SolvedDesign& solved, const Points3& centres, int side, double factor) {
  const MembraneSolution& m = solved.membranes[side];
  Wrenches fine = Wrenches::Zero(centres.rows(), 6), coarse = fine;
  add_wrenches(m.forces, m.pin_corners, centres, fine);
  add_wrenches(m.coarse_forces, m.pin_corners, centres, coarse);
  return solved.loads + (factor - 1) * extrapolate<Wrenches>(fine, coarse);
}

// Failure of the verdict on pushing forces, if any.
std::optional<Finding> failure_of(const UnilateralResult& result, const BalanceSystem& system,
                                  double f_min, double scale) {
  if (result.solve.status == SolveStatus::unfinished) return Finding{"margin.unknown"};
  if (result.solve.converged() && floor_is_reached(result.largest_floor, f_min, scale)) {
    return std::nullopt;
  }
  Finding::Pairs contacts;
  for (int point : result.critical_points) {
    const std::array<int, 2>& pair = system.points()[point].tile;
    if (contacts.size() == most_named) break;
    if (std::find(contacts.begin(), contacts.end(), pair) == contacts.end()) {
      contacts.push_back(pair);
    }
  }
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
  const double f_min = solved.f_min_ratio * std::max(0.0, solved.forces.normal_mean);
  UnilateralOptions options;
  options.friction_coefficient = std::min(p.margin_friction, p.friction_coefficient);
  options.scale = force_scale(solved);
  const Progress serial = one_at_a_time(progress);
  parallel_each(2, [&](int s) {
    BalanceSystem system = make_balance_system(geometry, p);
    const Wrenches loads = scaled_loads(solved, centres, s, 1 + out.mismatch / 100);
    const Points3 start = solve_contact_forces(system, loads).force;
    const UnilateralResult result = solve_unilateral(system, loads, start, options, serial);
    out.largest_floor[s] = result.largest_floor;
    out.failure[s] = failure_of(result, system, f_min, options.scale);
    if (out.failure[s]) {
      out.failure[s]->figures["side"] = s == 0 ? "front" : "back";
      out.failure[s]->figures["percent"] = out.mismatch;
      out.failure[s]->figures["mu"] = options.friction_coefficient;
    }
  });
  const auto unknown = [](const std::optional<Finding>& f) {
    return f && f->kind == "margin.unknown";
  };
  const auto fails = [&](const std::optional<Finding>& f) { return f && !unknown(f); };
  if (fails(out.failure[0]) || fails(out.failure[1])) {
    out.met = false;
  } else if (!unknown(out.failure[0]) && !unknown(out.failure[1])) {
    out.met = true;
  }
  return out;
}

}  // namespace curveups
