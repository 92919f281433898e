// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/layout.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/design/print_constants.hpp"
#include "curveups/layout/arrange.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {
namespace {

// Barrier parameter (energy units) at the start, for the first search for collisions, and at the
// end, where the objective has four digits.
constexpr double mu_start = 1e-1, mu_search = 3e-3, mu_end = 1e-6;
// mm beyond d_gap_min: nearer pairs are separated before the end as well.
constexpr double search_margin = 0.05;
// Violation of a constraint at the end, mm: a pin's area (mm2) lacks up to some times as much.
constexpr double accuracy = 0.1 * tolerance::constraint;
constexpr int max_iterations = 600, max_starts = 3;
constexpr int max_draft_iterations = 60;  // twice what a sound start takes

// Distance from the tiles to the rim of the slab that carries them and their anchors, and a gap,
// mm.
double print_margin(const Parameters& p) {
  const double anchors = p.anchors ? anchor_distance + 2 * p.anchor_radius : 0.0;
  const double support = p.support == "none" ? 0.0 : support_margin;
  return anchors + support + p.d_gap_min;
}

void require_pin_regions(const PinBounds& bounds) {
  std::vector<int> without;
  for (const SmallPin& pin : bounds.small) {
    if (pin.area <= 0 && (without.empty() || without.back() != pin.tile)) {
      without.push_back(pin.tile);
    }
  }
  if (without.empty()) return;
  throw InfeasibleDesign(
      "folds and neighbours leave no room for pins on " + std::to_string(without.size()) +
          (without.size() == 1 ? " tile" : " tiles"),
      "lower H_body or p_min, raise L, or smooth the target there (mend=on)", without);
}

}  // namespace

LayoutResult solve_layout(const DesignGeometry& geometry, const Parameters& parameters,
                          const Progress& progress, LayoutEffort effort,
                          const LayoutCallback& callback, const EarlierLayout* earlier) {
  require_pin_regions(geometry.pin_bounds);
  LayoutModel model = make_layout_model(geometry, parameters);
  LayoutState state = initial_layout(model, earlier);
  InteriorPoint method(make_energies(model), make_constraints(model), inset_bounds(model));
  const LayoutTerms terms = make_energies(model);  // for the callback and the report
  LayoutResult result;
  const bool draft = effort == LayoutEffort::draft;
  std::set<std::pair<int, int>> known;  // pairs of tiles that constraints keep apart
  for (const Contact& contact : geometry.tiles.contacts) {
    known.insert({contact.tile[0], contact.tile[1]});
  }
  const auto separate = [&](const LayoutState& at, double mu) {
    if (mu > mu_search) return false;
    const double margin = mu > mu_end ? search_margin : -accuracy;
    bool added = false;
    for (const Separation& pair :
         find_close_pairs(geometry.tiles, poses_of(model, at), parameters.d_gap_min + margin)) {
      if (!known.insert(std::minmax(pair.tile, pair.other)).second) continue;
      add_separation(model, pair);
      ++result.separations;
      added = true;
    }
    result.collision_rounds += added;
    return added;
  };
  double progressed = 0;  // never falls, though a new start may
  const Progress watched = [&](const std::string& what, double fraction) {
    progressed = std::max(progressed, fraction);
    if (callback) {
      double energy = 0;
      for (const auto& [name, value] : energies_by_name(terms, state)) energy += value;
      const double violation = largest_violation(make_constraints(model), state);
      if (!callback(poses_of(model, state), insets_of(state), energy, violation)) return false;
    }
    return keep_going(progress, what, progressed);
  };
  // Pairs far into one another can let multipliers grow without bound: the method then starts again
  // with all pairs known.
  for (int start = 0; start < max_starts; ++start) {
    const int most = (draft ? max_draft_iterations : max_iterations) - result.solve.iterations;
    SolveReport outcome =
        draft ? method.run(state, {mu_start, mu_search}, most, "layout", watched)
              : method.run(state, {mu_start, mu_end, accuracy}, most, "layout", watched, separate);
    outcome.iterations += result.solve.iterations;
    result.solve = outcome;
    if (draft || outcome.converged() || outcome.stopped()) break;
  }
  const Finishing finishing;
  result.energies = energies_by_name(terms, state);
  result.poses = arrange_pieces(geometry.tiles, poses_of(model, state), print_margin(parameters));
  result.T = flat_corners(geometry.tiles, result.poses);
  result.q = insets_of(state);
  return result;
}

}  // namespace curveups
