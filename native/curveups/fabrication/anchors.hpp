// SPDX-License-Identifier: LGPL-2.1-or-later
// Anchoring cylinders around the flat layout, which take the pull of the surplus membrane.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/outline.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/design/parameters.hpp"
#include "curveups/fabrication/engraving.hpp"

namespace curveups {

// The footprints of one piece: its tiles (convex polygons, seen from above), and what joins them
// (the gaps of contacts), which only keeps the outline in one loop.
struct PieceFootprint {
  std::vector<Polygon> tiles;
  std::vector<Polygon> joints;
};

// Centres of each piece's anchors on the line anchor_distance + anchor_radius from its outline (not
// in holes), spread evenly at about anchor_spacing; those that would come nearer than that distance
// to a tile of any piece, or too near to another anchor (narrow bays), are left out. The first of a
// piece is the one that is engraved.
std::vector<std::vector<Vec2>> place_anchors(const std::vector<PieceFootprint>& pieces,
                                             const Parameters& parameters);

// A cylinder from z = 0 to `height`, with the text sunk into its top face.
PrintBody make_anchor(const Vec2& centre, double radius, double height, const EngravedText& text,
                      double depth);

}  // namespace curveups
