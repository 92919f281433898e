// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces: what develops where a design's tiles are let go in the actuated configuration,
// with Coulomb friction, and the shape that the piece then has (the virtual scan). Beside the
// verdict on forces that could balance (verdict.hpp), this tells which do.
#pragma once

#include "curveups/contact/process_window.hpp"
#include "curveups/contact/virtual_scan.hpp"
#include "curveups/core/progress.hpp"
#include "curveups/physics/friction_needed.hpp"
#include "curveups/physics/margin.hpp"

namespace curveups {

struct SettledDesign {
  // The tiles came to rest under membranes, contacts and Coulomb's law; it holds where, besides, no
  // contact is open and the drift is at most the tolerance. Neither is known where they neither
  // come to rest nor drift further than that.
  bool converged = false;
  std::optional<bool> holds;
  std::optional<Finding> failure;  // why it does not hold
  double friction_coefficient = 0;
  double hold_tolerance = 0;  // mm
  // Normal force of a whole contact, N: mean and least over the contacts.
  double normal_mean = 0, normal_min = 0;
  std::vector<std::array<int, 2>> open_contacts;  // pairs of tiles whose contact carries nothing
  // The forces are those of the membranes' finite elements with the pins where they have settled,
  // but for this much: a force, or torque over L, over the mean force on a tile. 0: the tiles did
  // not come to rest.
  double element_change = 0;
  double largest_slip = 0;  // mm, of a point that pushes
  // Mean distance, mm, of the settled front surface from where it is while nothing slips: tiles and
  // bumps give way there as well, but friction holds.
  double drift = 0;
  VirtualScan scan;                 // beside the design's actuated surface
  Margin margin;                    // by the forces that exist, not by settling
  FrictionNeeded friction_needed;   // likewise
  std::vector<WindowRange> window;  // where the parameters ask for it and the design holds
  // The least friction down to which it holds; where the window is known.
  std::optional<double> holding_friction;
  int iterations = 0, factorizations = 0;
  // For pictures and for what follows.
  Eigen::VectorXd contact_force;  // normal, N, per contact
  Points3 corners;                // 3 M x 3: settled front corners, fitted to the design
  Eigen::VectorXd deviation;      // per tile, mean of its samples, mm
  // M x 7: how far each tile's centre has moved, and the quaternion (w last) it has turned by
  Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor> poses;
};

// Under the design's parameters. solved: solve_design's of these tiles, pins and membranes, where
// it is known; else null. Throws what make_tile_bodies and solve_design throw, Cancelled.
SettledDesign settle_design(const Design& design, const Progress& progress,
                            const SolvedHandle& solved = nullptr);

}  // namespace curveups
