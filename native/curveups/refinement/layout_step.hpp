// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of the layout's unknowns, and of vertices where they may move, under the linearised
// constraints, on some of the tiles.
#pragma once

#include <string>
#include <vector>

#include "curveups/layout/layout_terms.hpp"
#include "curveups/refinement/least_step.hpp"
#include "curveups/refinement/vertex_rows.hpp"

namespace curveups {

// One force as the step sees it: what it exceeds its goal by, and its gradient, both in units of
// the mean normal force.
struct ForceRow {
  double value;
  LayoutState gradient;
  Points3 by_vertex;  // of the moving vertices, layout unknowns held
};

// What a step costs.
struct StepPrices {
  double reach;  // mm that no unknown may exceed
  // Half the square of what a mm of a pose or an inset costs, and of E_target (Eq. 4, mm4).
  double layout = 1, target = 0;
  // Forces as hard constraints, or half their missing squares times this.
  double stiffness = 0;
  double farthest = 0;  // mm that coordinates of vertices stay within of their places in the target
};

// What holds a force row back, by falling share.
struct Obstacle {
  std::string what;        // "gap", "pin area", "pin keep-out", "inset at its limit"
  std::vector<int> tiles;  // ascending
  double multiplier;
};

struct LayoutStep {
  LayoutState step;                 // zero on tiles that are left alone
  Points3 vertex_step;              // mm, of the moving vertices
  std::vector<char> unmet;          // per force row: out of this step's reach
  std::vector<Obstacle> obstacles;  // the strongest ones, at most 8
};

// The unknowns in mm: angles times this lever.
double angle_lever(const LayoutModel& model);

// Tiles whose unknowns move some row by at least `share` of what the tile does that moves it most,
// and their neighbours; ascending.
std::vector<int> tiles_that_matter(const LayoutModel& model, const std::vector<ForceRow>& rows,
                                   double share);

// The least step of the given tiles and vertices that keeps every constraint the tiles take part in
// and lifts the force rows to zero. vertices may be null: none move.
LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& rows, const std::vector<int>& tiles,
                             const MovingVertices* vertices, const StepPrices& prices);

// Largest violation of the constraints, mm.
double largest_violation(const LayoutModel& model, const LayoutState& state);

// Puts the state back onto its constraints by least steps, each around what is violated, and adds
// separations to the model for tiles that have come too near. Returns whether all hold to
// tolerance::constraint; insets must keep their bounds already.
bool restore_constraints(LayoutModel& model, LayoutState& state, int most_steps);

}  // namespace curveups
