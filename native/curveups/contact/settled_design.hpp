// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces: what develops where a design's tiles are let go in the actuated configuration,
// with Coulomb friction, and the shape that the piece then has (the virtual scan). Beside the
// verdict on forces that could balance (verdict.hpp), this tells which do.
#pragma once

#include <optional>

#include "curveups/contact/tile_world.hpp"

namespace curveups {

struct SettleOptions {
  int max_steps = 60, max_iterations = 600;
  double hold_tolerance = 0;  // mm, on the drift; 0 stands for 1 % of L
  // Young's modulus of the tiles, MPa. Assumed: printed resins and PLA have 1500 to 3500.
  double tile_modulus = 2000;
  // Coefficients of friction at which holding is tried, from the design's own downwards.
  double friction_step = 0.05;
  bool find_holding_friction = true;
};

// Distances of the settled front surface from the design's actuated one, after the rigid motion
// that fits it best, mm.
struct VirtualScan {
  double mean = 0, rms = 0, p95 = 0, largest = 0;  // of samples of the settled surface
  double hausdorff = 0;                            // the larger of both directions' largest
};

struct SettledDesign {
  // The tiles came to rest under membranes, contacts and Coulomb's law; it holds where, besides, no
  // contact is open and the drift is at most the tolerance.
  bool converged = false, holds = false;
  double friction_coefficient = 0;
  double hold_tolerance = 0;  // mm
  // Normal force of a whole contact, N: mean and least over the contacts.
  double normal_mean = 0, normal_min = 0;
  std::vector<std::array<int, 2>> open_contacts;  // pairs of tiles whose contact carries nothing
  double largest_slip = 0;                        // mm, of a point that pushes
  // Mean distance, mm, of the settled front surface from where it is while nothing slips: tiles and
  // bumps give way there as well, but friction holds.
  double drift = 0;
  VirtualScan scan;
  // The least of the tried coefficients down to which the design holds; none where it does not
  // hold at its own.
  std::optional<double> holding_friction;
  int steps = 0, iterations = 0, factorizations = 0;
  // For pictures and for what follows.
  Eigen::VectorXd contact_force;  // normal, N, per contact
  Points3 corners;                // 3 M x 3: settled front corners, fitted to the design
  Eigen::VectorXd deviation;      // per tile, mean of its samples, mm
  Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>
      poses;  // M x 7: how far each tile's
              // centre has moved, and the quaternion (w last) it has turned by
};

// store: as verify_design has it. Throws InvalidInput for options that are no numbers, what
// make_tile_bodies and take_or_solve throw, Cancelled.
SettledDesign settle_design(const Design& design, SolutionStore* store,
                            const SettleOptions& options, const Progress& progress);

}  // namespace curveups
