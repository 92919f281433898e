// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/verdict.hpp"

#include <algorithm>
#include <utility>

namespace curveups {
namespace {

// The contacts of the heaviest points of a unilateral solution, each once.
std::vector<std::array<int, 2>> critical_contacts(const UnilateralResult& result,
                                                  const BalanceSystem& system) {
  std::vector<std::array<int, 2>> pairs;
  for (int point : result.critical_points) {
    const std::array<int, 2>& pair = system.points()[point].tile;
    if (std::find(pairs.begin(), pairs.end(), pair) != pairs.end()) continue;
    pairs.push_back(pair);
    if (pairs.size() == 4) break;
  }
  return pairs;
}

void judge_least_squares(const VerdictInput& in, VerificationReport& report) {
  const SolvedDesign& solved = in.solved;
  const ContactFigures& f = report.contact_forces;
  if (f.points > 0 && !(f.normal_mean > 0)) report.reasons.push_back({"no_pressure"});
  if (f.points_below_f_min > 0) {
    const Finding::Pairs weakest = {in.system.points()[solved.forces.weakest_point].tile};
    report.reasons.push_back({f.pulling_points > 0 ? "weak_points.pulling" : "weak_points",
                              tiles_of(f.invalid_contacts),
                              {{"points", f.points_below_f_min},
                               {"pulling", f.pulling_points},
                               {"f_min", f.f_min},
                               {"contacts", f.invalid_contacts},
                               {"least", f.normal_min},
                               {"weakest", weakest}}});
  }
  const std::vector<int>& unbalanced = solved.forces.unbalanced_tiles;
  if (!unbalanced.empty()) {
    report.reasons.push_back({"unbalanced", unbalanced, {{"held", unbalanced}}});
  }
  auto say = [&](const char* kind, const std::vector<int>& pieces) {
    for (int tile : pieces) {
      const std::vector<int> piece = {tile};
      report.reasons.push_back({kind, piece, {{"tile", piece}}});
    }
  };
  const Parameters& parameters = solved.design.parameters;
  say(parameters.gravity == "held" ? "in_the_air.held" : "in_the_air", solved.carried.in_the_air);
  say("tips_over", solved.carried.tipping);
  if (solved.f_min_ratio > parameters.f_min_ratio) report.warnings.push_back({"coarse_mesh"});
  if (!solved.undecided.empty() && f.points_below_f_min == 0) {
    report.warnings.push_back({"undecided",
                               tiles_of(solved.undecided),
                               {{"f_min", f.f_min}, {"contacts", solved.undecided}}});
  }
}

void judge_unilateral(const VerdictInput& in, VerificationReport& report) {
  const UnilateralFigures& u = report.unilateral;
  if (u.feasible && u.feasible_at_tips == false) {
    report.warnings.push_back(
        {"least_force.tips", {}, {{"mu", u.friction_coefficient}, {"f_min", u.floor}}});
  }
  if (u.feasible) return;
  Finding found = {"least_force"};
  if (u.status == SolveStatus::infeasible) found.kind = "no_balance";
  if (u.status == SolveStatus::unfinished) found.kind = "balance_unknown";
  std::vector<Finding> more;
  if (u.status == SolveStatus::infeasible && u.sliding_play) {
    more.push_back({"dimples_stop", {}, {{"play", *u.sliding_play}}});
  }
  const Finding::Pairs contacts = critical_contacts(in.unilateral, in.system);
  if (u.status != SolveStatus::unfinished) found.tiles = tiles_of(contacts);
  found.figures = {{"mu", u.friction_coefficient}, {"least", u.largest_floor},
                   {"pull", -u.largest_floor},     {"f_min", u.floor},
                   {"contacts", contacts},         {"more", std::move(more)}};
  report.reasons.push_back(std::move(found));
}

const char* name_of(Side side) { return side == Side::front ? "front" : "back"; }

// Warnings about what the makers of sheets and glue promise. The verdict does not depend on them.
void judge_materials(const Parameters& parameters, VerificationReport& report) {
  const double elongation = 100 * (report.physics.stretch_99 - 1);
  if (elongation > parameters.elongation_at_break) {
    report.warnings.push_back(
        {"sheet_tears",
         {},
         {{"elongation", elongation}, {"limit", parameters.elongation_at_break}}});
  }
  if (report.overloaded_tiles.empty()) return;
  const GlueLoad& load = report.glue.shear;
  report.warnings.push_back({"glue_shear",
                             report.overloaded_tiles,
                             {{"side", name_of(load.side)},
                              {"tile", std::vector<int>{load.tile}},
                              {"shear", load.shear},
                              {"limit", load.limit},
                              {"overloaded", report.overloaded_tiles}}});
}

void judge_membranes(const VerdictInput& in, VerificationReport& report) {
  if (!in.crossing.empty()) {
    report.reasons.push_back(
        {"membrane.covers", tiles_of(in.crossing), {{"contacts", in.crossing}}});
  }
  if (!report.physics.converged) {
    report.reasons.push_back({"no_equilibrium", {}, {{"residual", report.physics.residual}}});
  }
  for (Side side : {Side::front, Side::back}) {
    const int s = static_cast<int>(side);
    const MembraneClearance& c = in.clearance[s];
    const std::vector<int> tile = {c.tile};
    if (!is_clear(c.distance)) {
      report.reasons.push_back(cut_by_membrane(side, c.tile, -c.distance));
    } else if (c.distance < safe_clearance) {
      report.warnings.push_back(
          {"membrane.touches",
           tile,
           {{"side", name_of(side)}, {"tile", tile}, {"clearance", c.distance}}});
    }
    const std::vector<int>& slack = in.slack_tiles[s];
    if (!slack.empty()) {
      report.warnings.push_back(
          {"membrane.slack", slack, {{"side", name_of(side)}, {"beside", slack}}});
    }
  }
}

}  // namespace

Finding cut_by_membrane(Side side, int tile, double depth) {
  return {"membrane.cuts",
          {tile},
          {{"side", name_of(side)}, {"tile", std::vector<int>{tile}}, {"depth", depth}}};
}

void give_verdict(const VerdictInput& input, VerificationReport& report) {
  judge_least_squares(input, report);
  judge_unilateral(input, report);
  judge_membranes(input, report);
  judge_materials(input.solved.design.parameters, report);
  report.valid = report.reasons.empty();
}

}  // namespace curveups
