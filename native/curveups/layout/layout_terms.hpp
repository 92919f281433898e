// SPDX-License-Identifier: LGPL-2.1-or-later
// The energies and constraints of the layout, of the unknowns of one tile or of two. A new one is a
// file, a line here and a line in layout_terms.cpp.
#pragma once

#include <map>
#include <string>

#include "curveups/layout/layout_model.hpp"
#include "curveups/numerics/interior_point.hpp"

namespace curveups {

// Weights of alignment, packing and springs in Eq. 9, those of the paper's figures.
inline constexpr double w_a = 30, w_p = 30, w_s = 1;

using LayoutTerm = Residuals;
using LayoutTerms = std::vector<std::unique_ptr<LayoutTerm>>;

// Residuals of Eq. 9 with their weights inside: E = sum of squares, twice the terms' values. The
// terms refer to the model.
LayoutTerms make_energies(const LayoutModel& model);

// Hard constraints, mm: every element must be at least 0. Bounds of insets are not among them;
// inset_bounds has them.
LayoutTerms make_constraints(const LayoutModel& model);
std::vector<Bound> inset_bounds(const LayoutModel& model);

// Eq. 9's share of each term, by name.
std::map<std::string, double> energies_by_name(const LayoutTerms& terms, const LayoutState& state);

// One term per file.
std::unique_ptr<LayoutTerm> make_alignment_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_packing_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_spring_energy(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_gap_constraint(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_pin_area_constraint(const LayoutModel& model);
std::unique_ptr<LayoutTerm> make_pin_keepout_constraint(const LayoutModel& model);

}  // namespace curveups
