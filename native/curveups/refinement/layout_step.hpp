// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of the layout's unknowns under its linearised constraints, on some of the tiles.
#pragma once

#include <string>
#include <vector>

#include "curveups/layout/block_function.hpp"
#include "curveups/refinement/least_step.hpp"

namespace curveups {

// One normal force as the step sees it: what it exceeds its goal by, and its gradient, both in
// units of the mean normal force.
struct ForceRow {
  double value;
  LayoutState gradient;
};

// What holds a force row back, by falling share.
struct Obstacle {
  std::string what;        // "gap", "pin area", "pin keep-out", "inset at its limit"
  std::vector<int> tiles;  // ascending
  double multiplier;
};

struct LayoutStep {
  LayoutState step;                 // zero on tiles that are left alone
  std::vector<char> unmet;          // per force row: out of this step's reach
  std::vector<Obstacle> obstacles;  // the strongest ones, at most 8
};

// The unknowns in mm: angles times this lever.
double angle_lever(const LayoutModel& model);

// Tiles whose unknowns move some row by at least `share` of what the tile does that moves it most,
// and their neighbours; ascending.
std::vector<int> tiles_that_matter(const LayoutModel& model, const std::vector<ForceRow>& rows,
                                   double share);

// The least step (mm) of the given tiles that keeps every constraint they take part in and lifts
// the force rows to zero; no unknown moves farther than `reach` (mm).
LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& rows, const std::vector<int>& tiles,
                             double reach);

// Largest violation of the constraints, mm.
double largest_violation(const LayoutModel& model, const LayoutState& state);

// Puts the state back onto its constraints by least steps, each around what is violated, and adds
// separations to the model for tiles that have come too near. Returns whether all hold to
// tolerance::constraint; insets must keep their bounds already.
bool restore_constraints(LayoutModel& model, LayoutState& state, int most_steps);

}  // namespace curveups
