// SPDX-License-Identifier: LGPL-2.1-or-later
// Figures of tiles and contacts: how much a target leaves before a tile can't be made, before
// anything is solved; what a design is, from what is saved of it alone; how far a layout is
// stretched.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/design/constraints.hpp"
#include "curveups/layout/layout_model.hpp"

namespace curveups {

// M tiles, N contacts of a target. Figures are closed forms of the mesh; stretch is that of the
// conformal map with which a layout begins. Pins are bounded as compute_pin_bounds bounds them.
struct TargetFigures {
  Edges contacts;                   // N x 2 tiles
  Eigen::VectorXd dihedral;         // N, degrees: convex (ridge) positive
  Eigen::VectorXd dihedral_margin;  // N, degrees by which the fold could grow, all others as they
                                    // are, before a back face beside it vanishes; negative: it has
  Eigen::VectorXd back_scale;       // M: length of the back face over that of the front face
  PerSide pin_area;                 // M, front and back, mm2: of the largest pin there
  Eigen::VectorXd stretch;  // M: by how much the layout's start scales the tile's place, so that
                            // the median tile fits; 0 where the map turns the tile over, NaN
                            // where a piece has no flat map (a closed one, say)
  Eigen::VectorXd least_stretch;  // M: below this the start leaves the tile less than d_gap_min
  Eigen::VectorXd most_stretch;   // M: above this the start has a slack membrane beside it, even
                                  // with the smallest pins; infinite for a tile without contacts
  // False where a tile has no back face: truncation planes and overlaps mean nothing then, pins
  // are bounded by the planes at vertices alone, and what follows is empty.
  bool shaped = true;
  Eigen::VectorXd interface_share;  // N: the interface's back edge over its front edge; 0: a hinge
  // M, front and back, mm: by how much the tops of pins that come as near as they may stand over
  // the tile's corners and contacts, along the surface's normal. A taut membrane passes below its
  // pins' tops: where this is negative it cuts into the tile. Corners on the boundary or a cut do
  // not count: there is no membrane.
  PerSide membrane_clearance;
  // Pairs of tiles without a common vertex that run into one another: those that a plane between
  // them cuts off, and those that no plane parts.
  std::vector<std::array<int, 2>> trimmed, overlapping;
};

// Stretch goes by mean gaps: a tile of inradius r in a place scaled by s has gaps of 2 r (s - 1). A
// layout evens out what is below the least or above the most: neither is a bound of what can be
// laid out. Folds too sharp for the thickness and targets that can't be laid flat are no errors.
// Throws what make_tile_mesh throws.
TargetFigures target_figures(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters);

// Obstacles and warnings of a target: "sharp_fold" (error): folds sharper than a tile of this
// thickness can have; "folded_over" (error): tiles that overlap in the target whatever is cut off;
// "joint.room" (error): no room for stitching holes; "hinge": contacts that are only a hinge;
// "small_pin": pin sides that can't reach A_pin_min; "edge_length": edges far from L. Throws what
// make_tile_mesh throws.
std::vector<Finding> check_target(const TriangleMesh& mesh, const Edges& cuts,
                                  const Parameters& parameters);

// Counts, areas, gaps and pins of a finished design.
struct DesignFigures {
  Edges contacts;           // N x 2 tiles
  Eigen::VectorXd gap;      // N, mm: the flat gap that Eq. 7 bounds, see contact_gaps
  PerSide pin_area;         // M, mm2; negative where insets turn a pin over
  std::vector<int> hinges;  // contacts that are only a hinge
  int three_point_contacts = 0;
  std::array<int, 5> truncation_types{};  // pairs settled by each type, from 1
  std::vector<std::array<int, 2>> unresolved;
  std::vector<std::array<int, 2>> shortened;  // Truncation::shortened
  // mm that bumps leave of d_gap_min between flat tiles: all of it where walls are recessed for
  // them.
  double flat_clearance = 0;
  double actuated_area = 0, flat_area = 0;  // mm2
  ConstraintReport constraints;
  std::vector<Finding> reasons;  // why these make it not valid; none: they do not
};

// Throws what make_geometry throws.
DesignFigures evaluate_design(const Design& design);

// Factor by which the conformal map scales each tile, over the area-weighted geometric mean of its
// piece; at least 1e-6, which it is where the map turned the tile over. Tiles can't shrink: where
// the map shrinks the surface, all the rest of the layout has to spread.
Eigen::VectorXd relative_scale(const TileMesh& tiles);

// The largest over the least.
double scale_spread(const Eigen::VectorXd& relative_scale);

// Stretch of a layout: cuts are compared by these figures.
struct LayoutFigures {
  double scale_spread = 1;
  double area_ratio = 1;   // flat over actuated area
  double energy = 0;       // Eq. 9 per contact: what cuts are chosen by
  double spring_mean = 0;  // of contacts and sides: the membrane's length at rest between facing
                           // pins over its actuated length (the ratio in Eq. 16)
  int slack_springs = 0;   // those above 1: no tension holds the contact on this side
};

LayoutFigures layout_figures(const DesignGeometry& geometry, const Parameters& parameters,
                             const FlatPoses& poses, const Array6& q);

}  // namespace curveups
