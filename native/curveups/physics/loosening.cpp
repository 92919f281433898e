// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/physics/loosening.hpp"

#include <algorithm>
#include <iterator>

#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "curveups/physics/verdict.hpp"

namespace curveups {
namespace {

bool add(const LoosePins& more, LoosePins& pins) {
  for (std::size_t s = 0; s < pins.size(); ++s) {
    std::vector<int> both;
    std::set_union(pins[s].begin(), pins[s].end(), more[s].begin(), more[s].end(),
                   std::back_inserter(both));
    pins[s] = std::move(both);
  }
  return !more[0].empty() || !more[1].empty();
}

// Beyond this share of the pins of a part of a membrane, glue that lets go goes on doing so from
// pin to pin: what is left is not looked at and does not count as holding.
constexpr double most_loose = 0.25;

// Whether most of the pins of each part of both membranes are still glued.
bool most_hang(const TileMesh& tiles, const LoosePins& loose) {
  std::vector<char> joined(tiles.cut.size());
  for (std::size_t e = 0; e < joined.size(); ++e) joined[e] = !tiles.cut[e];
  const std::vector<int> part = face_components(tiles.topology, joined);
  for (const std::vector<int>& pins : loose) {
    std::vector<int> count(part.size(), 0), gone(part.size(), 0);  // by part
    for (int p : part) ++count[p];
    for (int i : pins) ++gone[part[i]];
    if (std::any_of(part.begin(), part.end(),
                    [&](int p) { return gone[p] > most_loose * count[p]; })) {
      return false;
    }
  }
  return true;
}

bool at_rest(const MembraneSolution& m) {
  return m.state.solve.converged() && m.coarse.state.solve.converged();
}

}  // namespace

Loosening loosen_pins(const DesignGeometry& geometry, const SolvedDesign& solved,
                      const LoosePins& overloaded, const std::vector<Points3>& tips,
                      const Progress& progress) {
  const Design& design = solved.design;
  Loosening out;
  if (!add(overloaded, out.pins)) return out;
  out.holds = false;
  try {
    SolvedDesign state;
    do {
      ++out.rounds;
      if (!most_hang(geometry.tiles, out.pins)) return out;
      state = solve_without_pins(geometry, solved, out.pins, progress);
    } while (add(
        overloaded_pins(glue_loads(geometry.tiles, design.q, state.membranes, design.parameters)),
        out.pins));
    if (!at_rest(state.membranes[0]) || !at_rest(state.membranes[1])) return out;
    out.f_min = state.f_min_ratio * std::max(0.0, state.forces.normal_mean);
    // What is left must press the tiles together by more than cone programs tell from nothing.
    bool holds = state.forces.normal_mean > UnilateralOptions{}.tolerance * force_scale(solved);
    const Progress serial = one_at_a_time(progress);
    auto look_for_floor = [&](Touching where, std::vector<ContactPoint> points) {
      BalanceSystem system = make_balance_system(geometry, design.parameters, std::move(points));
      find_floor(state, where, system, serial);
    };
    const std::vector<ContactPoint> corners = contact_corners(geometry, design.parameters);
    bool answered = true;
    try {
      parallel_tasks({[&] { look_for_floor(Touching::at_corners, corners); },
                      [&] {
                        if (!any_tips(tips)) return;
                        look_for_floor(Touching::at_tips, tie_to_corners(corners, tips).points);
                      }});
    } catch (const SolverFailure&) {
      answered = false;
    }
    for (const std::optional<UnilateralResult>& found : state.floor) {
      if (!found) continue;
      holds = holds && found->solve.status == SolveStatus::converged &&
              floor_is_reached(found->largest_floor, out.f_min, force_scale(state));
      out.largest_floor =
          std::min(out.largest_floor.value_or(found->largest_floor), found->largest_floor);
    }
    out.holds = holds && answered;
  } catch (const SolverFailure&) {  // no equilibrium without these pins
  }
  return out;
}

}  // namespace curveups
