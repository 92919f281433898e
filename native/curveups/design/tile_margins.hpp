// SPDX-License-Identifier: LGPL-2.1-or-later
// How much every tile and every contact of a target has left before it can't be made: closed forms
// of the mesh, before any layout. What check_target says in words, as figures.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/pin_bounds.hpp"

namespace curveups {

// M tiles, N contacts. Where a tile has no back face (back_scale below tiles_without_back's bound)
// truncation planes, pins and overlaps mean nothing: `shaped` is false, and what is listed after it
// is empty.
struct TileMargins {
  Edges contacts;            // N x 2 tiles
  Eigen::VectorXd dihedral;  // N, degrees: convex (ridge) positive
  Eigen::VectorXd
      dihedral_margin;         // N, degrees by which the fold could grow, all others as they are,
                               // before a back face beside it vanishes; negative: it has vanished
  Eigen::VectorXd back_scale;  // M: length of the back face over that of the front face
  bool shaped = true;
  Eigen::VectorXd interface_share;  // N: the interface's back edge over its front edge; 0: a hinge
  PerSide pin_area;                 // M, front and back, mm2: of the largest pin there
  PerSide membrane_clearance;  // M, front and back, mm: by how much the tops of pins that come as
                               // near as they may stand over the tile's corners and contacts,
                               // along the surface's normal. A taut membrane passes below its
                               // pins' tops: where this is negative it cuts into the tile.
                               // Corners on the boundary or a cut do not count: there is none.
  std::vector<std::array<int, 2>> trimmed;      // tiles without a common vertex that run into one
                                                // another and are cut off by a plane between them
  std::vector<std::array<int, 2>> overlapping;  // tiles that no plane parts
};

// Pins as compute_pin_bounds bounds them, so that p_min gives way where not even A_pin_floor is
// possible. Throws what make_tile_mesh throws.
TileMargins tile_margins(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters);

}  // namespace curveups
