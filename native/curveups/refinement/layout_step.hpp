// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of the layout's unknowns, and of vertices where they may move, under the linearised
// constraints, on some of the tiles.
#pragma once

#include <functional>
#include <vector>

#include "curveups/layout/layout_terms.hpp"
#include "curveups/numerics/least_step.hpp"
#include "curveups/refinement/vertex_rows.hpp"

namespace curveups {

// Force in a step: its excess over the goal, and its gradient, both in units of the mean normal
// force.
struct ForceRow {
  double value;
  LayoutState gradient;
  Points3 by_vertex;  // row a moving vertex, layout unknowns held
};

// Weights and limits of a step. A step minimises half the squared length (mm2) of all moves of
// poses and insets, and `target` times half of E_target (Eq. 4, mm4).
struct StepWeights {
  double trust_radius;  // mm: largest move of an unknown
  double target = 0;    // 1 / mm2
  double largest_displacement =
      0;  // mm, by coordinate: of vertices from their places in the target
};

// Further objective of a step of all tiles: weight / 2 (r + J d) . S^-1 (r + J d), d the unknowns
// of all tiles, 9 each.
struct StepObjective {
  SparseRows jacobian;                                           // J
  Eigen::VectorXd value;                                         // r
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> solve;  // S^-1 v
  double weight = 1;
};

struct LayoutStep {
  LayoutState step;     // zero on other tiles
  Points3 vertex_step;  // mm, row a moving vertex
};

// Tiles whose unknowns move some row by at least `share` of what the tile does that moves it most,
// and their neighbours; ascending.
std::vector<int> tiles_that_matter(const LayoutModel& model, const std::vector<ForceRow>& rows,
                                   double share);

// Least step of the given tiles and vertices that keeps every constraint on these tiles and lifts
// the force rows to zero. vertices may be null: none move. objective may be null; else the tiles
// are all and no vertices move.
LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& forces, const std::vector<int>& tiles,
                             const MovingVertices* vertices, const StepWeights& weights,
                             const StepObjective* objective = nullptr);

// Puts the state back onto its constraints by least steps, each around the violated ones, and adds
// separations to the model for tiles that have come too near. True where all hold to
// tolerance::constraint in the end; insets must keep their bounds already.
bool restore_constraints(LayoutModel& model, LayoutState& state, int max_steps);

}  // namespace curveups
