// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts that let a target lie flat, or lie flat with less stretch, and their effect on the layout.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/layout/cut_candidates.hpp"
#include "curveups/layout/diagnostics.hpp"
#include "curveups/numerics/solve_report.hpp"

namespace curveups {

struct CutSuggestion {
  Edges edges;        // vertex pairs to cut besides the given cuts and those of earlier suggestions
  double length = 0;  // mm
  std::vector<Finding> reasons;
  // Figures of draft layouts; none where the solver broke down, or where the sheet would lie on
  // itself (crossing_rims).
  std::optional<LayoutFigures> before, after;
};

struct CutSuggestionOptions {
  int most = 1;
  std::vector<std::array<int, 2>> weak;  // tile pairs of contacts that stay weak
};

struct CutSuggestions {
  std::vector<CutSuggestion> cuts;  // in the order of their making; those so far where stopped
  SolveReport solve;                // iterations: drafts
};

// Greedy search: draft layouts of the three candidates with the most even conformal maps (variance
// of the log scale over the area); the one with the least energy per contact is taken, until there
// are `most` or none helps enough. For a target that can't be flattened (closed pieces, handles),
// or whose map is too uneven, the first suggestion opens it. Throws what make_geometry throws.
CutSuggestions suggest_cuts(const TriangleMesh& mesh, const Edges& cuts,
                            const Parameters& parameters, const CutSuggestionOptions& options,
                            const Progress& progress);

}  // namespace curveups
