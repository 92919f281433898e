// SPDX-License-Identifier: LGPL-2.1-or-later
// Values for each tile and contact: of a target, that show before anything is solved where it is
// hard; of a layout, that need no membranes.
#pragma once

#include "curveups/design/design.hpp"

namespace curveups {

struct TargetFields {
  Edges contacts;            // N x 2 tiles
  Eigen::VectorXd dihedral;  // N, degrees: convex (ridge) positive
  PerSide pin_area_margin;   // M, mm2: area of the largest pin less A_pin_min
  Eigen::VectorXd stretch;  // M: by how much the layout's start scales the tile's place; a map that
                            // turns the tile over counts as 0; NaN where a piece has no flat map (a
                            // closed one, say)
  Eigen::VectorXd least_stretch;  // M: below this the start leaves the tile less than d_gap_min
  Eigen::VectorXd
      most_stretch;  // M: above this the start has a slack membrane next to it, even with the
                     // smallest pins that A_pin_min allows; infinite for a tile without contacts
};

// least and most are of the start and go by the mean gap: a tile of inradius r in a place scaled by
// s has gaps of 2 r (s - 1). Half of all tiles begin below their least, since the start fits the
// median; a layout evens that out, so that neither is a bound of what can be laid out. Throws what
// make_tile_mesh throws; folds too sharp for the thickness and targets that can't be laid flat are
// no errors here.
TargetFields target_fields(const TriangleMesh& mesh, const Edges& cuts,
                           const Parameters& parameters);

struct DesignFields {
  Edges contacts;       // N x 2 tiles
  Eigen::VectorXd gap;  // N, mm: what Eq. 7 bounds, see contact_gaps
  PerSide pin_area;     // M, mm2; negative where insets turn a pin over
};

// Throws what make_geometry throws.
DesignFields design_fields(const Design& design);

}  // namespace curveups
