// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/layout_terms.hpp"

namespace curveups {

LayoutTerms make_energies(const LayoutModel& model) {
  LayoutTerms functions;
  functions.push_back(make_alignment_energy(model));
  functions.push_back(make_packing_energy(model));
  functions.push_back(make_spring_energy(model));
  return functions;
}

LayoutTerms make_constraints(const LayoutModel& model) {
  LayoutTerms functions;
  functions.push_back(make_gap_constraint(model));
  functions.push_back(make_pin_area_constraint(model));
  functions.push_back(make_pin_keepout_constraint(model));
  return functions;
}

std::vector<Bound> inset_bounds(const LayoutModel& model) {
  const PinBounds& bounds = model.geometry->pin_bounds;
  std::vector<Bound> out;
  for (int i = 0; i < model.tile_count(); ++i) {
    for (int k = 0; k < 6; ++k) out.push_back({i, 3 + k, bounds.lower(i, k), bounds.upper(i, k)});
  }
  return out;
}

std::map<std::string, double> energies_by_name(const LayoutTerms& terms, const LayoutState& state) {
  std::map<std::string, double> out;
  for (const auto& term : terms) out[std::string(term->name())] += 2 * term->value(state);
  return out;
}

}  // namespace curveups
