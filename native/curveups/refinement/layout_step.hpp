// SPDX-License-Identifier: LGPL-2.1-or-later
// Steps of the layout's unknowns, and of vertices where they may move, under the linearised
// constraints, on some of the tiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "curveups/layout/layout_terms.hpp"
#include "curveups/numerics/least_step.hpp"
#include "curveups/refinement/vertex_rows.hpp"

namespace curveups {

// One force as the step sees it: what it exceeds its goal by, and its gradient, both in units of
// the mean normal force.
struct ForceRow {
  double value;
  LayoutState gradient;
  Points3 by_vertex;  // of the moving vertices, layout unknowns held
};

// What a step minimises and how far it may go: half the squared length in mm of all moves of poses
// and insets is the unit.
struct StepWeights {
  double trust_radius;  // mm that no unknown may exceed
  double target = 0;    // of half of E_target (Eq. 4, mm4)
  double largest_displacement =
      0;  // mm, by coordinate: of vertices from their places in the target
};

// What a step of all tiles minimises besides: weight / 2 (r + J d) . S^-1 (r + J d), d the unknowns
// of all tiles, 9 each.
struct StepObjective {
  SparseRows jacobian;                                           // J
  Eigen::VectorXd value;                                         // r
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> solve;  // S^-1 v
  double weight = 1;
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
  std::vector<Obstacle> obstacles;  // the strongest ones, at most 8
};

// The unknowns in mm: angles times this lever.
double angle_lever(const LayoutModel& model);

// Tiles whose unknowns move some row by at least `share` of what the tile does that moves it most,
// and their neighbours; ascending.
std::vector<int> tiles_that_matter(const LayoutModel& model, const std::vector<ForceRow>& rows,
                                   double share);

// The least step of the given tiles and vertices that keeps every constraint the tiles take part in
// and lifts the force rows to zero. vertices may be null: none move. objective may be null; else
// the tiles are all and no vertices move.
LayoutStep least_layout_step(const LayoutModel& model, const LayoutState& state,
                             const std::vector<ForceRow>& forces, const std::vector<int>& tiles,
                             const MovingVertices* vertices, const StepWeights& weights,
                             const StepObjective* objective = nullptr);

// Puts the state back onto its constraints by least steps, each around what is violated, and adds
// separations to the model for tiles that have come too near. Returns whether all hold to
// tolerance::constraint; insets must keep their bounds already.
bool restore_constraints(LayoutModel& model, LayoutState& state, int max_steps);

}  // namespace curveups
