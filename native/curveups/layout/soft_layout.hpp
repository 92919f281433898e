// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 9 with soft terms only, for interaction: the layout as it settles, iterate by iterate.
#pragma once

#include <optional>

#include "curveups/layout/layout.hpp"

namespace curveups {

struct SoftLayoutStart {
  FlatPoses poses;
  Array6 q;
};

// The same energies as solve_layout with E_c and E_pa in place of hard constraints; insets keep
// their bounds. A smooth least-squares problem with bounds: Ceres solves it. start: an earlier
// layout of the same tiles (after a cut, say), by default the conformal one. Poses stay where they
// are: nothing is turned or arranged. Stopped it returns what it has. The energies have collision
// and pin area too.
LayoutResult solve_soft_layout(const DesignGeometry& geometry, const Parameters& parameters,
                               const std::optional<SoftLayoutStart>& start, int max_iterations,
                               const Progress& progress, const LayoutCallback& callback = {});

}  // namespace curveups
