// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/verdict.hpp"

#include <algorithm>

#include "curveups/core/text.hpp"

namespace curveups {
namespace {

std::string names(const std::vector<int>& tiles) { return tile_names(tiles, 8); }
std::string names(const std::vector<std::array<int, 2>>& pairs) {
  return listed(pairs, 8, pair_name);
}

// The contacts of the heaviest points of a unilateral solution, each once.
std::vector<std::array<int, 2>> critical_contacts(const UnilateralResult& result,
                                                  const BalanceSystem& system) {
  std::vector<std::array<int, 2>> pairs;
  for (int point : result.critical_points) {
    const std::array<int, 2>& pair = system.points()[point].tile;
    if (pair[0] < 0 || std::find(pairs.begin(), pairs.end(), pair) != pairs.end()) continue;
    pairs.push_back(pair);
    if (pairs.size() == 4) break;
  }
  return pairs;
}

void judge_least_squares(const VerdictInput& in, VerificationReport& report) {
  const ContactFigures& f = report.contact_forces;
  if (f.points > 0 && !(f.normal_mean > 0)) {
    report.reasons.push_back("the membranes do not press the tiles together");
  }
  if (f.points_below_f_min > 0) {
    const int p = in.forces.weakest_point;
    std::string reason = std::to_string(f.points_below_f_min) + " contact points";
    reason += f.pulling_points > 0
                  ? " push too weakly or pull (" + std::to_string(f.pulling_points) + " pull)"
                  : " push too weakly";
    reason += ": less than f_min = " + number(f.f_min) + " N at " + names(f.invalid_contacts) +
              "; the weakest has " + number(f.normal_min) + " N at " +
              pair_name(in.system.points()[p].tile);
    report.reasons.push_back(reason);
  }
  if (!in.forces.unbalanced_tiles.empty()) {
    report.reasons.push_back("contacts can't hold " + names(in.forces.unbalanced_tiles) +
                             ": a hinge or nothing at all carries them");
  }
  for (int tile : in.in_the_air) {
    report.reasons.push_back(
        "nothing carries the piece of " + tile_name(tile) +
        (in.parameters.gravity == "held"
             ? ": held_tiles names none of its tiles"
             : ": it does not reach the ground, where the lowest piece rests"));
  }
  if (in.floor_from_mesh) {
    report.warnings.push_back(
        {"f_min is the estimated error of the membrane mesh, which is more than "
         "f_min_ratio asks for: lower mesh_size",
         {}});
  }
}

// What one unilateral problem lacks; empty where it reaches f_min. where: "" or " at bumps' tips".
std::string lack_of_push(const UnilateralFigures& u, SolveStatus status, double largest_floor,
                         bool feasible, const std::string& where, const UnilateralResult& result,
                         const BalanceSystem& system) {
  if (feasible) return "";
  const std::string mu = number(u.friction_coefficient);
  const std::string first = ", first at " + names(critical_contacts(result, system));
  if (status == SolveStatus::infeasible) {
    return "with a friction coefficient of " + mu + " no pushing forces" + where +
           " balance the tiles: " + number(-largest_floor) + " N of pull would be needed" + first;
  }
  if (status == SolveStatus::unfinished) {
    return "whether pushing forces" + where + " within friction " + mu +
           " balance the tiles could not be shown";
  }
  return "pushing forces" + where + " within friction " + mu + " leave a least normal force of " +
         number(largest_floor) + " N, less than f_min = " + number(u.floor) + " N" + first;
}

void judge_unilateral(const VerdictInput& in, VerificationReport& report) {
  const UnilateralFigures& u = report.unilateral;
  std::string reason =
      lack_of_push(u, u.status, u.largest_floor, u.feasible, "", in.coulomb, in.system);
  if (u.status == SolveStatus::infeasible && u.sliding_play) {
    reason += "; dimples stop what slides after " + number(*u.sliding_play) + " mm at most";
  }
  if (!reason.empty()) report.reasons.push_back(reason);
  if (!in.tips) return;
  reason = lack_of_push(u, *u.tips_status, u.tips_largest_floor, u.feasible_at_tips,
                        " at bumps' tips", *in.tips, *in.tips_system);
  if (!reason.empty() && in.parameters.gravity == "held") {
    reason += "; hold more tiles, or others (held_tiles)";
  }
  if (!reason.empty()) report.reasons.push_back(reason);
}

const char* name_of(Side side) { return side == Side::front ? "front" : "back"; }

// What the sheets and the glue on pins hold, by their makers. A warning: neither is computed.
void judge_materials(const VerdictInput& in, VerificationReport& report) {
  const double elongation = 100 * (report.physics.stretch_99 - 1);
  if (elongation > in.parameters.elongation_at_break) {
    report.warnings.push_back({"more than 1 % of the membranes is stretched by " +
                                   number(elongation) + " % or more, beyond elongation_at_break (" +
                                   number(in.parameters.elongation_at_break) +
                                   " %): they tear; lower tau",
                               {}});
  }
  const GlueLoad& load = report.glue.shear;
  if (load.shear > in.parameters.glue_strength) {
    report.warnings.push_back(
        {"the glue on the " + std::string(name_of(load.side)) + " pin of " + tile_name(load.tile) +
             " carries " + number(load.shear) + " MPa of shear, more than glue_strength (" +
             number(in.parameters.glue_strength) + " MPa): raise A_pin_min or lower tau",
         {load.tile}});
  }
}

void judge_membranes(const VerdictInput& in, VerificationReport& report) {
  const char* sides[2] = {"front", "back"};
  if (!report.physics.converged) {
    report.reasons.push_back("the membranes' equilibrium was not reached (residual " +
                             number(report.physics.residual) + ")");
  }
  for (int s = 0; s < 2; ++s) {
    const MembraneClearance& c = in.clearance[s];
    if (!is_clear(c.distance)) {
      report.reasons.push_back("the " + std::string(sides[s]) + " membrane would cut " +
                               number(-c.distance) + " mm into the body of " + tile_name(c.tile) +
                               ": raise H_pin or lower insets there");
    } else if (c.distance < safe_clearance) {
      report.warnings.push_back({"the " + std::string(sides[s]) + " membrane touches the body of " +
                                     tile_name(c.tile) + " (clearance " + number(c.distance) +
                                     " mm)",
                                 {c.tile}});
    }
    if (!in.slack_tiles[s].empty()) {
      report.warnings.push_back(
          {"the " + std::string(sides[s]) + " membrane is slack beside " + names(in.slack_tiles[s]),
           in.slack_tiles[s]});
    }
  }
}

}  // namespace

void give_verdict(const VerdictInput& input, VerificationReport& report) {
  judge_least_squares(input, report);
  judge_unilateral(input, report);
  judge_membranes(input, report);
  judge_materials(input, report);
  report.valid = report.reasons.empty();
}

}  // namespace curveups
