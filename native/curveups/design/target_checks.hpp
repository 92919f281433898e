// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds tiles and pins that can't be made on a target, before solving.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/design/constraints.hpp"

namespace curveups {

// "sharp_fold" (error): folds sharper than a tile of this thickness can have; "folded_over"
// (error): tiles that overlap in the target whatever is cut off; "hinge": contacts that are only a
// hinge; "small_pin": pin sides that can't reach A_pin_min; "edge_length": edges far from L. Throws
// what make_tile_mesh throws.
std::vector<Finding> check_target(const TriangleMesh& mesh, const Edges& cuts,
                                  const Parameters& parameters);

// What a finished design is, from what is saved of it alone.
struct DesignFigures {
  int contacts = 0;
  std::vector<int> hinges;  // contacts that are only a hinge
  int three_point_contacts = 0;
  std::array<int, 5> truncation_types{};  // pairs settled by each type, from 1
  std::vector<std::array<int, 2>> unresolved;
  std::vector<std::array<int, 2>> shortened;  // Truncation::shortened
  // What bumps leave of d_gap_min between flat tiles, mm: all of it where walls are recessed for
  // them.
  double flat_clearance = 0;
  double actuated_area = 0, flat_area = 0;  // mm2
  ConstraintReport constraints;
  std::vector<Finding> reasons;  // why these make it not valid; none: they do not
};

// Throws what make_geometry throws.
DesignFigures evaluate_design(const Design& design);

}  // namespace curveups
