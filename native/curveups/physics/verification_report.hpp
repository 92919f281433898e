// SPDX-License-Identifier: LGPL-2.1-or-later
// What verification finds of a design: figures in mm and N, reasons, warnings, arrays for pictures.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "curveups/physics/solved_design.hpp"

namespace curveups {

// Figures of both membranes.
struct PhysicsFigures {
  int triangles = 0, free_vertices = 0;
  // Per side (front, back), on each of the two meshes.
  int coarse_iterations[2] = {0, 0}, fine_iterations[2] = {0, 0};
  double residual = 0;  // largest force on a free vertex over the mean on a glued one
  bool converged = false;
  double wrinkled_fraction = 0;  // of the membranes' rest area: wrinkled or slack
  double slack_fraction = 0;
  double largest_stretch = 0;  // of a triangle: at a pin corner, and larger on finer meshes
  double stretch_99 = 0;       // 99 % of the rest area is stretched less: converges
  double force_balance = 0, torque_balance = 0;  // see wrench_balance
  double normal_force_error = 0;  // estimated, mean over the points, relative to normal_mean
  double largest_normal_force_error = 0;
  double least_force_error = 0;  // of the least normal force (error_of_least), likewise relative
  int refined_tiles = 0;         // around which the mesh was refined (solve_design)
  double clearance_mm = 0;       // membranes to bodies
  double mean_tile_force = 0;    // N
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
  // The same where only bumps' tips touch; without a value where there are none. A warning alone.
  std::optional<bool> feasible_at_tips;
  // Dimples: how far walls can slide on one another before these hold them, mm.
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

// All that verification found.
struct VerificationReport {
  bool valid = false;
  std::vector<Finding> reasons;
  std::vector<Finding> warnings;
  // False where the membranes can't be laid out at all: the reasons say why, the rest is empty.
  bool computed = false;
  // False where weak points were enough (VerificationOptions): reasons, warnings and the unilateral
  // problem were left out.
  bool complete = true;
  PhysicsFigures physics;
  ContactFigures contact_forces;
  UnilateralFigures unilateral;
  LargestGlueLoads glue;
  std::vector<int> overloaded_tiles;  // pins whose glue carries more than glue_strength, ascending

  Edges contact_tiles;  // per contact
  Eigen::VectorXd contact_normal_min, contact_normal_mean, contact_friction_ratio;
  Eigen::VectorXd
      tile_normal_min;  // least normal force at each tile's points; NaN without contacts
  Wrenches elastic;     // M x 6, of the membranes
  SolvedHandle solved;  // what all of this was read from
  std::array<MembranePicture, 2> membrane;
};

}  // namespace curveups
