// SPDX-License-Identifier: LGPL-2.1-or-later
// Data that the parts of a print model share while it is built.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/anchors.hpp"
#include "curveups/fabrication/print_model.hpp"

namespace curveups {

// "Anchor P1 A002" and the like.
std::string numbered(const char* format, int a, int b = 0);

// The tile (row of F) of a piece that is nearest to a place.
int nearest_tile(const PieceFootprint& footprint, const Vec2& place);

// Least distance of a corner of one of two convex polygons from the other.
double least_distance(const Polygon& a, const Polygon& b);

// Tiles of these bodies (in their frames, row by row) with their pins and caps, where the layout
// has them. Needs the model's geometry, q, pieces and flat motions.
std::vector<PrintBody> flat_tiles(const PrintModel& model, const std::vector<ConvexBody>& bodies,
                                  const std::vector<std::vector<WallCap>>& caps);

}  // namespace curveups
