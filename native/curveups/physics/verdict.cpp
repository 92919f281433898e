// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/verdict.hpp"

#include <algorithm>
#include <utility>

namespace curveups {
namespace {

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
  auto add_pieces = [&](const char* kind, const std::vector<int>& first_tiles) {
    for (int tile : first_tiles) {
      const std::vector<int> piece = {tile};
      report.reasons.push_back({kind, piece, {{"tile", piece}}});
    }
  };
  const Parameters& parameters = solved.design.parameters;
  add_pieces(parameters.gravity == "held" ? "in_the_air.held" : "in_the_air",
             solved.carried.in_the_air);
  add_pieces("tips_over", solved.carried.tipping);
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
  Finding reason = {"least_force"};
  if (u.status == SolveStatus::infeasible) reason.kind = "no_balance";
  if (u.status == SolveStatus::unfinished) reason.kind = "balance_unknown";
  std::vector<Finding> more;
  if (u.status == SolveStatus::infeasible && u.sliding_play) {
    more.push_back({"dimples_stop", {}, {{"play", *u.sliding_play}}});
  }
  const Finding::Pairs contacts = critical_contacts(in.unilateral, in.system);
  if (u.status != SolveStatus::unfinished) reason.tiles = tiles_of(contacts);
  reason.figures = {{"mu", u.friction_coefficient}, {"least", u.largest_floor},
                    {"pull", -u.largest_floor},     {"f_min", u.floor},
                    {"contacts", contacts},         {"more", std::move(more)}};
  report.reasons.push_back(std::move(reason));
}

// Warnings where sheets or glue exceed their makers' limits. The verdict does not depend on them.
void judge_materials(const Parameters& parameters, VerificationReport& report) {
  const double elongation = 100 * (report.physics.stretch_99 - 1);
  if (elongation > parameters.elongation_at_break) {
    report.warnings.push_back(
        {"sheet_tears",
         {},
         {{"elongation", elongation}, {"limit", parameters.elongation_at_break}}});
  }
  const GlueFigures& glue = report.glue;
  if (glue.overloaded.empty()) return;
  report.warnings.push_back({"glue_shear",
                             glue.overloaded,
                             {{"side", side_name(glue.shear.side)},
                              {"tile", std::vector<int>{glue.shear.tile}},
                              {"shear", glue.shear.shear},
                              {"limit", glue.limit},
                              {"overloaded", glue.overloaded}}});
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
    if (!is_clear(c.distance)) {
      report.reasons.push_back(cut_by_membrane(side, c.tile, -c.distance));
    } else if (c.distance < safe_clearance) {
      report.warnings.push_back({"membrane.touches",
                                 {c.tile},
                                 {{"side", side_name(side)},
                                  {"tile", std::vector<int>{c.tile}},
                                  {"clearance", c.distance}}});
    }
    const std::vector<int> slack = tiles_beside_slack(in.solved.membranes[s]);
    if (!slack.empty()) {
      report.warnings.push_back(
          {"membrane.slack", slack, {{"side", side_name(side)}, {"beside", slack}}});
    }
  }
}

}  // namespace

Finding cut_by_membrane(Side side, int tile, double depth) {
  return {"membrane.cuts",
          {tile},
          {{"side", side_name(side)}, {"tile", std::vector<int>{tile}}, {"depth", depth}}};
}

void give_verdict(const VerdictInput& input, VerificationReport& report) {
  judge_least_squares(input, report);
  judge_unilateral(input, report);
  judge_membranes(input, report);
  judge_materials(input.solved.design.parameters, report);
  report.valid = report.reasons.empty();
}

}  // namespace curveups
