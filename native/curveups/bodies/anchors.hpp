// SPDX-License-Identifier: LGPL-2.1-or-later
// Anchoring cylinders around the flat layout, which take the pull of the surplus membrane.
#pragma once

#include <array>
#include <vector>

#include "curveups/bodies/outline.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/design/parameters.hpp"

namespace curveups {

// Footprints of one piece, seen from above.
struct PieceFootprint {
  std::vector<Polygon> tiles;              // convex
  std::vector<int> rows;                   // tiles' rows of F, ascending
  std::vector<Polygon> joints;             // gaps of contacts, which keep the outline in one loop
  std::vector<std::array<int, 2>> joined;  // the two tiles of each gap
  std::vector<Vec2> anchors;               // axes
};

// Flat front corners of one side of a contact, in the order of its tile.
std::array<Vec2, 2> front_edge(const TileMesh& tiles, const FlatPoses& poses,
                               const Contact& contact, int side);

// Enters the gaps of contacts into the footprints of their pieces.
void join_footprints(std::vector<PieceFootprint>& pieces, const std::vector<int>& piece_of_tile,
                     const TileMesh& tiles, const FlatPoses& poses);

// Centres of each piece's anchors, evenly at about anchor_spacing on the line anchor_distance +
// anchor_radius around it (not in holes). Anchors that would come nearer than that distance to a
// tile of any piece, or too near to another anchor, are left out.
std::vector<std::vector<Vec2>> place_anchors(const std::vector<PieceFootprint>& pieces,
                                             const Parameters& parameters);

// Tile (row of F) of a piece that is nearest to a place.
int nearest_tile(const PieceFootprint& footprint, const Vec2& place);

// Makes a cylinder from z = 0 to `height`.
PrintBody make_anchor(const Vec2& centre, double radius, double height);

}  // namespace curveups
