// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation of the paper (section 5.1): from a target mesh to flat poses and pins.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "curveups/core/progress.hpp"
#include "curveups/layout/initial_layout.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

struct LayoutResult {
  FlatPoses poses;
  FlatCorners T;
  Array6 q;
  SolveReport solve;                       // residual: of the hard constraints, mm
  int collision_rounds = 0;                // searches for collisions that added separations
  int separations = 0;                     // pairs of tiles kept apart besides contacts
  std::map<std::string, double> energies;  // Eq. 9's terms by name, with their weights
};

// Receives every iterate: flat poses, insets, Eq. 9's value and the largest violation of the hard
// constraints, mm; false stops as progress does.
using LayoutCallback =
    std::function<bool(const FlatPoses&, const Array6&, double energy, double violation)>;

// draft: ends at the first search for collisions of a full one. The objective is known to some 2 %
// then; tiles without a contact may be too near to one another.
enum class LayoutEffort { full, draft };

// Conformal start, then Eq. 9 under hard constraints (interior_point.hpp). Eq. 7 alone does not
// keep tiles apart that share only a vertex, or nothing: the method searches for pairs nearer than
// d_gap_min, adds constraints and goes on, until there are none. Turned to the smallest bounding
// rectangle, pieces side by side. Stopped by the progress sink it returns the last iterate. Throws
// what initial_layout throws, InfeasibleDesign where a tile has no room for a pin, SolverFailure.
// earlier: start instead (initial_layout).
LayoutResult solve_layout(const DesignGeometry& geometry, const Parameters& parameters,
                          const Progress& progress, LayoutEffort effort = LayoutEffort::full,
                          const LayoutCallback& callback = {},
                          const EarlierLayout* earlier = nullptr);

}  // namespace curveups
