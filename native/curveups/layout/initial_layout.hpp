// SPDX-License-Identifier: LGPL-2.1-or-later
// Start of the layout: every tile lies rigidly in its triangle of a conformal map.
#pragma once

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// Inradius of a tile's front triangle, mm.
double tile_inradius(const TileMesh& tiles, int tile);

// Inradius of a tile with half a gap around it, mm; tiles that grow towards the back take more.
double inradius_with_gap(const TileMesh& tiles, int tile, double d_gap_min);

// A layout of tiles that have changed since. T: flat front corners, q: insets, mm; not finite for
// new tiles.
struct EarlierLayout {
  FlatCorners T;
  Array6 q;
};

// Conformal map of each piece, of the mesh opened along the cuts, scaled so that the median tile
// just fits with its gap; pieces stand side by side. Insets start a little above their lower
// bounds. Throws TopologyError for a piece without boundary. earlier: tiles lie about as there, and
// new ones between them, where most of a piece's tiles were there and none of it turns over.
LayoutState initial_layout(const LayoutModel& model, const EarlierLayout* earlier = nullptr);

}  // namespace curveups
