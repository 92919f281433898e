// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair of weak contacts: the paper's refinement (Eq. 3, Algorithm 1) as one global sequence of
// quadratic programs over flat poses and pins, with exact derivatives and normal forces >= f_min as
// hard constraints. Among the designs that keep them the one nearest to where it started, step by
// step, is taken; the actuated vertices stay where they are.
//
// The layout's constraints hold after every step: restored by least steps, so that weak forces are
// all that a step is judged by, and it is halved until it lifts them. Forces come from a mesh that
// follows the pins, corrected by what a fresh mesh, extrapolated as in verification, gave last; the
// verdict is a fresh mesh's alone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

struct RepairOptions {
  double reach = 0.2;  // mm that an unknown moves in a step at most, at first
  // Weak points are lifted to this times f_min (what the mesh error may take is to spare), and
  // points below `watched` times f_min must not fall below it.
  double goal = 1.5;
  double watched = 2.0;
  int most_steps = 30;
};

enum class RepairStatus { valid, stopped, blocked };

struct RepairStep {
  int weak_points;      // normal force below f_min
  double least_force;   // in units of f_min
  double largest_move;  // of an unknown in this step, mm
  bool fresh_mesh;      // judged on a fresh, extrapolated mesh
};

// A contact that stays weak, and what holds it.
struct BlockedContact {
  std::array<int, 2> tiles;
  double least_force;     // in units of f_min
  std::string reason;     // one sentence that names tiles
  std::vector<int> held;  // the tiles whose constraints are in the way
};

struct RepairResult {
  Design design;  // the best found: fewest weak points, then the largest least force
  RepairStatus status = RepairStatus::blocked;
  std::vector<RepairStep> steps;  // the first is the design given
  double restored_mm = 0;         // by how much constraints were violated in the design given
  double largest_move = 0;        // of a front corner in the layout or an inset, mm
  std::vector<BlockedContact> blocked;
  std::vector<std::string> suggestions;
};

// Valid: least-squares normal forces at every contact point >= f_min and all constraints of the
// layout kept. Cancelled through progress it is stopped and keeps the best so far. Throws what
// make_geometry throws, InvalidInput for arrays that disagree, InfeasibleDesign where the layout's
// constraints can't be restored or membranes fold over even so, SolverFailure.
RepairResult repair_design(const Design& design, const RepairOptions& options,
                           const Progress& progress);

}  // namespace curveups
