// SPDX-License-Identifier: LGPL-2.1-or-later
// Cuts that let a target lie flat, or lie flat with less stretch, each with what it does to the
// layout.
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
  bool opens = false;  // without it there is no layout worth speaking of
  // Of draft layouts; none where there is none, where the solver broke down, or where the sheet
  // would lie on itself (crossing_rims).
  std::optional<LayoutFigures> before, after;
};

struct CutSuggestionOptions {
  int most = 1;
  std::vector<std::array<int, 2>> weak;  // tile pairs of contacts that stay weak
};

struct CutSuggestions {
  std::vector<CutSuggestion> cuts;  // in the order in which they are to be made
  // Iterations: drafts that were solved. Stopped, `cuts` has those found so far.
  SolveReport solve;
};

// Greedy: of the candidates the three whose conformal maps are the most even (variance of the log
// scale over the area) are tried by a draft layout, and the one of least energy per contact is
// taken, until `most` are found or none is worth it. A target that can't be flattened at all
// (closed pieces, handles), or whose map is not workable, first gets what opens it, as one
// suggestion. Throws what make_geometry throws.
CutSuggestions suggest_cuts(const TriangleMesh& mesh, const Edges& cuts,
                            const Parameters& parameters, const CutSuggestionOptions& options,
                            const Progress& progress);

}  // namespace curveups
