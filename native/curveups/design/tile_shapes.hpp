// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners of tiles and pins in both configurations, in closed form, for pictures.
#pragma once

#include "curveups/design/design.hpp"

namespace curveups {

// Lengths in mm. A tile has six corners: the front ones in the order of F, then the back ones below
// them, before truncation and without recessed walls; a pin six: three at its foot on the tile's
// face, then three at its end. Flat: front faces in the plane z = 0, back faces at -H_body.
struct TileShapes {
  using Corners = Eigen::Matrix<double, Eigen::Dynamic, 18, Eigen::RowMajor>;  // M x 6 x 3
  using Pins = Eigen::Matrix<double, Eigen::Dynamic, 36, Eigen::RowMajor>;     // M x 2 x 6 x 3
  Corners actuated, flat;         // flat: no rows where there is no layout
  Pins actuated_pins, flat_pins;  // front pin, then back pin; no rows where there are no insets
  Edges contacts;                 // N x 2 tiles, as TileMesh::contacts
  Edges contact_sides;            // N x 2: which edge (0 to 2) of each of the two
};

// T and q have a row per tile, or none where there is no layout yet. Throws InvalidInput for other
// sizes and for numbers that are not finite, InfeasibleDesign as make_geometry does.
TileShapes tile_shapes(const TriangleMesh& mesh, const Edges& cuts, const Parameters& parameters,
                       const FlatCorners& T, const Array6& q);

}  // namespace curveups
