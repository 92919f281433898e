// SPDX-License-Identifier: LGPL-2.1-or-later
// Eq. 9 with soft terms only, for interaction: the layout as it settles, iterate by iterate.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "curveups/layout/layout_model.hpp"

namespace curveups {

struct SoftLayoutStart {
  FlatPoses poses;
  Array6 q;
};

struct SoftLayoutResult {
  FlatPoses poses;
  Array6 q;
  int iterations = 0;
  bool converged = false;
  bool stopped = false;
  std::map<std::string, double>
      energies;  // by name, with their weights, collision and pin area too
};

// Called after every accepted step with the poses, the insets and Eq. 9's value; false stops.
using SoftLayoutCallback = std::function<bool(const FlatPoses&, const Array6&, double energy)>;

// The same energies as solve_layout with E_c and E_pa in place of hard constraints; insets keep
// their bounds. A smooth least-squares problem with bounds: Ceres solves it. start: an earlier
// layout of the same tiles (after a cut, say), by default the conformal one. Poses stay where they
// are: nothing is turned or arranged.
SoftLayoutResult solve_soft_layout(const DesignGeometry& geometry, const Parameters& parameters,
                                   const std::optional<SoftLayoutStart>& start, int max_iterations,
                                   const SoftLayoutCallback& callback);

}  // namespace curveups
