// SPDX-License-Identifier: LGPL-2.1-or-later
// Figures of tiles and contacts: margins of a target before anything is solved, figures of a saved
// design, stretch of a layout.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/design/constraints.hpp"
#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Figures of a target with M tiles and N contacts, in closed form; stretch is that of the conformal
// map with which a layout begins.
struct TargetFigures {
  Edges contacts;                   // N x 2 tiles
  Eigen::VectorXd dihedral;         // N, degrees: convex (ridge) positive
  Eigen::VectorXd dihedral_margin;  // N, degrees by which this fold alone could grow before a back
                                    // face beside it vanishes; negative: it has vanished
  Eigen::VectorXd back_scale;       // M: length of the back face over that of the front face
  PerSide pin_area;                 // M, front and back, mm2: largest pin (compute_pin_bounds)
  Eigen::VectorXd stretch;  // M: scale of each tile's triangle at the layout's start, so that the
                            // median tile fits; 0 where the map turns the tile over, NaN where a
                            // piece has no flat map (a closed one, say)
  Eigen::VectorXd least_stretch;  // M: below this the start leaves the tile less than d_gap_min
  Eigen::VectorXd most_stretch;   // M: above this the start has a slack membrane beside it, even
                                  // with the smallest pins; infinite for a tile without contacts
  // False where a tile has no back face: only planes at vertices bound pins then, and the fields
  // below are empty.
  bool shaped = true;
  Eigen::VectorXd interface_share;  // N: the interface's back edge over its front edge; 0: a hinge
  // M, front and back, mm: least height of pins' tops over the tile's corners and contacts
  // (membrane_clearance.hpp). Where it is negative a taut membrane cuts into the tile.
  PerSide membrane_clearance;
  // Pairs of tiles without a common vertex that overlap: those that a plane between them trims, and
  // those that no plane separates.
  std::vector<std::array<int, 2>> trimmed, overlapping;
};

// Stretch stands for mean gaps: a tile of inradius r in a place scaled by s has gaps of 2 r (s -
// 1). A layout evens out what is below the least or above the most: they are no strict bounds.
// Folds too sharp for the thickness and targets that can't be laid flat are no errors. Throws what
// make_tile_mesh throws.
TargetFigures target_figures(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters);

// Obstacles and warnings of a target: "sharp_fold" (error): folds too sharp for tiles of this
// thickness; "folded_over" (error): tiles that overlap whatever is trimmed; "joint.room" (error):
// no room for stitching holes; "hinge": contacts that are only a hinge; "small_pin": pin sides that
// can't reach A_pin_min; "edge_length": edges far from L. Throws what make_tile_mesh throws.
std::vector<Finding> check_target(const TriangleMesh& mesh, const Edges& cuts,
                                  const Parameters& parameters);

// Counts, areas, gaps and pins of a finished design.
struct DesignFigures {
  Edges contacts;           // N x 2 tiles
  Eigen::VectorXd gap;      // N, mm: the flat gap that Eq. 7 bounds, see contact_gaps
  PerSide pin_area;         // M, mm2; negative where insets turn a pin over
  std::vector<int> hinges;  // contacts that are only a hinge
  int three_point_contacts = 0;
  std::array<int, 5> truncation_types{};  // pairs separated by each type, from 1
  std::vector<std::array<int, 2>> unresolved;
  std::vector<std::array<int, 2>> shortened;  // Truncation::shortened
  // Part of d_gap_min that bumps leave between flat tiles, mm.
  double flat_clearance = 0;
  double actuated_area = 0, flat_area = 0;  // mm2
  ConstraintReport constraints;
  std::vector<Finding> reasons;  // broken constraints; none: valid
};

// Throws what make_geometry throws.
DesignFigures evaluate_design(const Design& design);

// Scale of each tile in the conformal map over the area-weighted geometric mean of its piece; at
// least 1e-6, also where the map turns the tile over. Tiles can't shrink: where the map shrinks the
// surface, all the rest of the layout has to spread.
Eigen::VectorXd relative_scale(const TileMesh& tiles);

// Largest over least scale.
double scale_spread(const Eigen::VectorXd& relative_scale);

// Stretch of a layout, by which cuts are compared.
struct LayoutFigures {
  double scale_spread = 1;
  double area_ratio = 1;   // flat over actuated area
  double energy = 0;       // Eq. 9 per contact: the criterion for cuts
  double spring_mean = 0;  // ratio of Eq. 16, mean over contacts and sides: the membrane's length
                           // at rest between facing pins over its actuated length
  int slack_springs = 0;   // ratios above 1: no tension holds the contact on this side
};

LayoutFigures layout_figures(const DesignGeometry& geometry, const Parameters& parameters,
                             const FlatPoses& poses, const Array6& q);

}  // namespace curveups
