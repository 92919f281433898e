// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair of weak contacts: the paper's refinement (Eq. 3, Algorithm 1) as one global sequence of
// quadratic programs over flat poses, pins and actuated vertices, with exact derivatives:
//   minimise E_target   subject to the layout's constraints and E_tight = 0,
// (w_tight infinite): least-squares normal forces at every contact point, and the largest floor of
// the unilateral problem, are at least f_min. Vertices move only where poses and pins do not
// suffice: E_target stays zero as long as it can. Among these designs each step takes the nearest.
//
// Least steps restore the layout's constraints after every step, so that weak forces alone judge a
// step; it is halved until it lifts them. Forces come from a mesh that follows the pins
// (tracked_forces.hpp); the verdict is given on a fresh mesh.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "curveups/core/progress.hpp"
#include "curveups/design/design.hpp"
#include "curveups/physics/verification.hpp"
#include "curveups/refinement/judgement.hpp"

namespace curveups {

struct RepairStep {
  int weak_points;     // normal force below f_min
  double least_force;  // in units of f_min
  double least_floor;  // largest floor of the unilateral problem in units of f_min; NaN where it
                       // was not computed (points are weak, and the floor was not the reason)
  bool vertices;       // vertices moved
  bool fresh_mesh;     // judged on a fresh, extrapolated mesh
};

struct RepairResult {
  Design design;      // fewest weak points, then the largest least force
  SolveReport solve;  // converged: valid; unfinished: `blocked` or `cuts` have the reasons
  std::vector<RepairStep> steps;   // the first is the design given
  double restored_mm = 0;          // largest violation of constraints in the design given
  double largest_move = 0;         // of a front corner in the layout or an inset, mm
  double largest_vertex_move = 0;  // of an actuated vertex in this repair, mm
  std::vector<BlockedContact> blocked;
  // Deepest cut of either membrane into a body, as verification gives its reasons.
  std::vector<Finding> cuts;
  std::string breakdown;                           // error that ended it early, or empty
  std::optional<VerificationReport> verification;  // valid results only
};

inline constexpr int most_repair_steps = 60;

// Receives flat corners, insets, the number of weak points and the largest violation of the
// layout's constraints (mm) after every step; false stops as progress does.
using RepairCallback =
    std::function<bool(const FlatCorners&, const Array6&, double weak_points, double violation)>;

// Valid: least-squares normal forces at every contact point and the largest floor of the unilateral
// problem >= f_min, no membrane cuts into a body, and all constraints of the layout are kept. Where
// vertices move the result's target is the given design's target, or its mesh. Stopped through
// progress, keeps the best so far. Throws what make_geometry throws, InvalidInput for a target with
// other vertices than the mesh, InfeasibleDesign where the layout's constraints can't be restored
// or membranes fold over even so, SolverFailure. solved: solve_design's of the design, where it is
// known; else null.
RepairResult repair_design(const Design& design, const Progress& progress,
                           const RepairCallback& callback = {}, int max_steps = most_repair_steps,
                           SolvedHandle solved = nullptr);

}  // namespace curveups
