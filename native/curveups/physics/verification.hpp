// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact physical model of a design and its verdict: membranes, contact forces as in the paper,
// contacts that only push. Tiles touch at the corners of their interfaces.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/core/progress.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// Figures of both membranes.
struct PhysicsFigures {
  int triangles = 0, free_vertices = 0;
  // Newton steps per side (front, back), on each of the two meshes.
  int coarse_iterations[2] = {0, 0}, fine_iterations[2] = {0, 0};
  double residual = 0;  // largest force on a free vertex over the mean on a glued one
  bool converged = false;
  double wrinkled_fraction = 0;
  double stretch_99 = 0;                         // 99 % of the rest area is stretched less
  double force_balance = 0, torque_balance = 0;  // wrench_balance
  // Estimated errors of normal forces (SolvedDesign), relative to normal_mean.
  double normal_force_error = 0, largest_normal_force_error = 0, least_force_error = 0;
  double clearance_mm = 0;     // membranes to bodies
  double mean_tile_force = 0;  // N
};

struct ContactFigures {
  double normal_mean = 0, normal_min = 0, f_min = 0;  // N
  int points = 0, points_below_f_min = 0, pulling_points = 0;
  std::vector<std::array<int, 2>> invalid_contacts;  // tile pairs
  double friction_ratio_mean = 0, friction_ratio_max = 0;
  double imbalance = 0;
};

struct UnilateralFigures {
  SolveStatus status = SolveStatus::unfinished;  // without a floor
  bool feasible = false;                         // with floor f_min
  double friction_coefficient = 0;
  double floor = 0;          // N, f_min
  double largest_floor = 0;  // N
  // Feasible where only bumps' tips touch: a warning. Without a value where there are none.
  std::optional<bool> feasible_at_tips;
  // Slip of walls at which dimples stop them, mm; with dimples alone.
  std::optional<double> sliding_play;
};

// Arrays for pictures.
struct MembranePicture {
  Points2 flat;
  Points3 actuated;
  Triangles triangles;
  Points2 stretch;           // larger and smaller, per triangle
  std::vector<int> tension;  // 0 taut, 1 wrinkled, 2 slack
};

struct VerificationReport {
  bool valid = false;
  std::vector<Finding> reasons;
  std::vector<Finding> warnings;
  // False where the membranes can't be laid out: reasons tell why, the rest is empty.
  bool computed = false;
  // False where weak points ended it (VerificationOptions): without reasons, warnings and the
  // unilateral problem.
  bool complete = true;
  PhysicsFigures physics;
  ContactFigures contact_forces;
  UnilateralFigures unilateral;
  GlueFigures glue;

  Edges contact_tiles;  // per contact
  Eigen::VectorXd contact_normal_min, contact_normal_mean, contact_friction_ratio;
  Eigen::VectorXd tile_normal_min;  // least of each tile's points; NaN without contacts
  SolvedHandle solved;              // membranes and forces behind the figures
  std::array<MembranePicture, 2> membrane;
};

struct VerificationOptions {
  // End at weak contact points, without cone programs, clearances and a verdict
  // (VerificationReport::complete).
  bool weak_is_enough = false;
};

// Throws what make_geometry and plan_bumps throw (InfeasibleDesign, TopologyError, InvalidInput),
// SolverFailure, Cancelled. Results do not depend on the number of threads.
VerificationReport verify_design(const Design& design, const Progress& progress,
                                 const VerificationOptions& options = {});
// Verify a design that is solved. Throws what plan_bumps throws, SolverFailure, Cancelled.
VerificationReport verify_solved(const DesignGeometry& geometry, const SolvedHandle& solved,
                                 const Progress& progress, const VerificationOptions& options = {});

// Contact points of printed tiles: tips of bumps (bump_tips) at contacts that have some, else the
// corners of the interface (contact_corners).
std::vector<ContactPoint> points_at_tips(const std::vector<ContactPoint>& corners,
                                         const std::vector<Points3>& tips);

}  // namespace curveups
