// SPDX-License-Identifier: LGPL-2.1-or-later
// Anchoring cylinders around the flat layout, which take the pull of the surplus membrane.
#pragma once

#include <array>
#include <vector>

#include "curveups/bodies/outline.hpp"
#include "curveups/bodies/print_body.hpp"
#include "curveups/design/parameters.hpp"

namespace curveups {

// The footprints of one piece, seen from above: its tiles (convex polygons), what joins them (the
// gaps of contacts), which only keeps the outline in one loop.
struct PieceFootprint {
  std::vector<Polygon> tiles;
  std::vector<int> rows;  // of F, ascending
  std::vector<Polygon> joints;
  std::vector<std::array<int, 2>> joined;  // the two tiles of each
  std::vector<Vec2> anchors;               // axes
};

// The flat front corners of one side of a contact, as its tile runs along it.
std::array<Vec2, 2> front_edge(const TileMesh& tiles, const FlatPoses& poses,
                               const Contact& contact, int side);

// Enters what joins the tiles of contacts into the footprints of their pieces.
void join_footprints(std::vector<PieceFootprint>& pieces, const std::vector<int>& piece_of_tile,
                     const TileMesh& tiles, const FlatPoses& poses);

// Centres of each piece's anchors on the line anchor_distance + anchor_radius from its outline (not
// in holes), spread evenly at about anchor_spacing; those that would come nearer than that distance
// to a tile of any piece, or too near to another anchor (narrow bays), are left out.
std::vector<std::vector<Vec2>> place_anchors(const std::vector<PieceFootprint>& pieces,
                                             const Parameters& parameters);

// A cylinder from z = 0 to `height`.
PrintBody make_anchor(const Vec2& centre, double radius, double height);

}  // namespace curveups
