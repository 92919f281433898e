// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair of weak contacts: the paper's refinement (Eq. 3, Algorithm 1) as one global sequence of
// quadratic programs over flat poses, pins and actuated vertices, with exact derivatives:
//   minimise E_target + w_tight E_tight   subject to the layout's constraints,
// E_tight as hard constraints by default (w_tight infinite): least-squares normal forces at every
// contact point, and the largest floor of the unilateral problem, at least f_min. Vertices move
// only where poses and pins do not do: E_target stays zero as long as it can. Among designs alike
// in that the one nearest to where the step started is taken.
//
// The layout's constraints hold after every step: restored by least steps, so that weak forces are
// all that a step is judged by, and it is halved until it lifts them. Forces come from a mesh that
// follows the pins, corrected by what a fresh mesh, extrapolated as in verification, gave last; the
// verdict is a fresh mesh's alone.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"
#include "curveups/physics/validation.hpp"

namespace curveups {

struct RepairOptions {
  double reach = 0.2;  // mm that an unknown moves in a step at most, at first
  // Weak points are lifted to this times f_min (what the mesh error may take is to spare), and
  // points below `watched` times f_min must not fall below it.
  double goal = 1.5;
  double watched = 2.0;
  double penalty_goal = 1.1;  // times f_min, where tightness is a penalty
  // The same for the largest floor of the unilateral problem, which is one number.
  double floor_goal = 1.2;
  // Vertices stay within this times L of their places in the target, by coordinate.
  double farthest = 0.1;
  int most_steps = 30;
};

enum class RepairStatus { valid, stopped, blocked };

struct RepairStep {
  int weak_points;      // normal force below f_min
  double least_force;   // in units of f_min
  double least_floor;   // largest floor of the unilateral problem, in units of f_min; NaN where it
                        // was not looked at (points are weak, and it was not the reason)
  double largest_move;  // of an unknown in this step, mm
  bool vertices;        // whether vertices moved
  bool fresh_mesh;      // judged on a fresh, extrapolated mesh
};

// A contact that stays weak, and what holds it.
struct BlockedContact {
  std::array<int, 2> tiles;
  double least_force;     // in units of f_min
  std::string reason;     // one sentence that names tiles
  std::string obstacle;   // Obstacle::what, empty where there is none
  std::vector<int> held;  // the tiles whose constraints are in the way
};

struct RepairResult {
  Design design;  // the best found: fewest weak points, then the largest least force
  RepairStatus status = RepairStatus::blocked;
  std::vector<RepairStep> steps;   // the first is the design given
  double restored_mm = 0;          // by how much constraints were violated in the design given
  double largest_move = 0;         // of a front corner in the layout or an inset, mm
  double largest_vertex_move = 0;  // of an actuated vertex in this repair, mm
  std::shared_ptr<SolvedDesign> solved;  // of the design, where it is valid
  std::vector<BlockedContact> blocked;
  std::vector<std::string> suggestions;
};

// Valid: least-squares normal forces at every contact point and the largest floor of the unilateral
// problem >= f_min, no membrane cuts into a body, and all constraints of the layout are kept. Where
// vertices move the result's target is the given design's target, or its mesh. Cancelled through
// progress it is stopped and keeps the best so far. solved: what verification of this very design
// kept, taken over; or null. Throws what make_geometry throws, InvalidInput for arrays that
// disagree, InfeasibleDesign where the layout's constraints can't be restored or membranes fold
// over even so, SolverFailure.
RepairResult repair_design(const Design& design, const RepairOptions& options, SolvedDesign* solved,
                           const Progress& progress);

}  // namespace curveups
