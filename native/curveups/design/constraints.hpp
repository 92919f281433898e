// SPDX-License-Identifier: LGPL-2.1-or-later
// Violation of the hard constraints (Eqs. 6 to 8, global clearance) by a finished design, measured
// on the saved corners and independent of the optimiser.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

struct ConstraintReport {
  double max_rigidity_mm = 0;       // largest difference of flat and actuated edge lengths
  double max_gap_violation_mm = 0;  // Eq. 7, both sides, both directions, and the clearance of
                                    // any two tiles (separated by one edge normal)
  double max_pin_bound_violation_mm = 0;        // bounds, those of `relaxed` as relaxed; keep-outs
  std::vector<RelaxedBound> relaxed;            // PinBounds::relaxed
  double max_pin_area_violation_mm2 = 0;        // below what is required of the side (PinBounds)
  std::vector<SmallPin> small_pins;             // sides below A_pin_min, with the area they have
  std::vector<std::array<int, 2>> close_pairs;  // nearer than d_gap_min - tolerance::constraint
};

ConstraintReport check_constraints(const DesignGeometry& geometry, const FlatCorners& corners,
                                   const Array6& q, const Parameters& parameters);

// Per contact the gap that Eq. 7 bounds, mm: the least distance of the ends of one tile's edge from
// the line of the other's, both ways, on both faces.
Eigen::VectorXd contact_gaps(const TileMesh& tiles, const FlatPoses& poses);

// A pair of tiles and the edge of `tile` whose normal separates it best from `other` on both faces.
struct Separation {
  int tile, side_edge, other;
  double distance;  // the least over both faces; negative where they overlap along it
};

// All pairs of tiles whose best separation is below `clearance`, found with a grid, in ascending
// order of the lower and the higher tile.
std::vector<Separation> find_close_pairs(const TileMesh& tiles, const FlatPoses& poses,
                                         double clearance);

}  // namespace curveups
