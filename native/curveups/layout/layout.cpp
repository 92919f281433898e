// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/layout.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/print_margin.hpp"
#include "curveups/layout/arrange.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

// Complementarity (energy units) at the start, where the layout is settled enough to look for
// collisions, and at the end, where the objective has four digits.
constexpr double mu_start = 1e-1, mu_search = 2e-3, mu_end = 1e-6;
constexpr int max_iterations = 600, max_rounds = 12;
constexpr int max_draft_iterations = 60;  // twice what a sound start takes

void require_room_for_pins(const PinBounds& bounds) {
  std::vector<int> without;
  for (const SmallPin& pin : bounds.small) {
    if (pin.area <= 0 && (without.empty() || without.back() != pin.tile)) {
      without.push_back(pin.tile);
    }
  }
  if (without.empty()) return;
  throw InfeasibleDesign("folds and neighbours leave no room for pins on " +
                             std::to_string(without.size()) +
                             (without.size() == 1 ? " tile" : " tiles"),
                         "lower H_body or p_min, raise L, or smooth the target there", without);
}

}  // namespace

LayoutResult solve_layout(const DesignGeometry& geometry, const Parameters& parameters,
                          const Progress& progress, LayoutEffort effort,
                          const LayoutCallback& callback) {
  require_room_for_pins(geometry.pin_bounds);
  LayoutModel model = make_layout_model(geometry, parameters);
  LayoutState state = initial_layout(model);
  LayoutTerms energies = make_energies(model, false);
  InteriorPoint<LayoutTerm> method(
      {std::make_move_iterator(energies.begin()), std::make_move_iterator(energies.end())},
      make_constraints(model), inset_bounds(model));
  const LayoutTerms terms = make_energies(model, false);  // for those who listen
  LayoutResult result;
  double mu = mu_start, goal = mu_search;
  double progressed = 0;  // never falls: collisions that are found start a round's share again
  const int most = effort == LayoutEffort::draft ? max_draft_iterations : max_iterations;
  try {
    while (true) {
      // Of all rounds' progress the share of this one: rounds after the first are short.
      const double done = result.collision_rounds == 0 && goal > mu_end ? 0.0 : 0.6;
      const Progress scaled = [&](const std::string& what, double fraction) {
        progressed = std::max(progressed, done + (done > 0 ? 0.4 : 0.6) * fraction);
        if (callback) {
          double energy = 0;
          for (const auto& [name, value] : energies_by_name(terms, state)) energy += value;
          const double violation = largest_violation(make_constraints(model), state);
          if (!callback(poses_of(model, state), insets_of(state), energy, violation)) return false;
        }
        return keep_going(progress, what, progressed);
      };
      const SolveReport outcome =
          method.run(state, mu, goal, most - result.solve.iterations, "layout", scaled);
      result.solve = {outcome.status, result.solve.iterations + outcome.iterations,
                      outcome.residual};
      if (outcome.stopped() || effort == LayoutEffort::draft) break;
      const double clearance = parameters.d_gap_min - 0.5 * tolerance::constraint;
      const std::vector<Separation> close =
          find_close_pairs(geometry.tiles, poses_of(model, state),
                           goal > mu_end ? parameters.d_gap_min - 1e-3 : clearance);
      for (const Separation& pair : close) add_separation(model, pair);
      result.separations += static_cast<int>(close.size());
      if (!close.empty()) ++result.collision_rounds;
      if ((goal <= mu_end && close.empty()) || result.solve.iterations >= most ||
          result.collision_rounds >= max_rounds) {
        if (!close.empty()) result.solve.status = SolveStatus::unfinished;
        break;
      }
      mu = goal > mu_end ? mu_search : 1e-4;
      goal = mu_end;
      if (!outcome.converged()) {
        // Pairs that were far into one another have let multipliers grow without bound: what was
        // found of the pairs stays, the rest starts again.
        method.forget();
        mu = mu_start;
      }
    }
  } catch (const Cancelled&) {  // while looking for collisions
    result.solve.status = SolveStatus::stopped;
  }
  const Finishing finishing;
  result.energies = energies_by_name(terms, state);
  result.poses = arrange_pieces(geometry.tiles, poses_of(model, state), print_margin(parameters));
  result.T = flat_corners(geometry.tiles, result.poses);
  result.q = insets_of(state);
  return result;
}

}  // namespace curveups
