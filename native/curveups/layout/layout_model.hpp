// SPDX-License-Identifier: LGPL-2.1-or-later
// The unknowns of the flat layout and the constants that its energies and constraints share.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/constraints.hpp"

namespace curveups {

// Nine unknowns a tile: x, y of its front triangle's centroid (mm), the angle by which its frame is
// turned (rad), and the six pin insets (mm; three in front, three behind). Poses are exactly rigid:
// Eqs. 8, 10 and 15 hold by construction.
inline constexpr int unknowns_per_tile = 9;
using LayoutState = Eigen::Matrix<double, Eigen::Dynamic, unknowns_per_tile, Eigen::RowMajor>;

// Index of an inset among a tile's unknowns.
inline int inset_unknown(Side side, int t) { return 3 + inset_index(side, t); }

struct LayoutTile {
  std::array<std::array<Vec2, 3>, 2> corner;  // per side, in the tile's frame about its centroid
  std::array<Vec2, 3> outward;                // unit normals of the edges, the same on both sides
  // Pin corner t = corner[side][t] + per_previous[t] q[t-1] + per_own[t] q[t].
  std::array<Vec2, 3> per_previous, per_own;
  std::array<double, 3> length;  // front edges
  double area;                   // front triangle
  std::array<double, 2> shift;   // per side: sum over edges of length times inset of the face
};

// Gap between a corner of a tile and an edge of another, on one side (Eq. 7).
struct CornerGap {
  int tile, edge;     // the edge's line ...
  int other, corner;  // ... and the corner that must keep its distance from it
  Side side;
};

struct LayoutModel {
  const DesignGeometry* geometry;
  Parameters parameters;
  double L;  // normalises the energies
  std::vector<LayoutTile> tiles;
  std::vector<CornerGap> gaps;  // contacts, in both directions, then pairs that collided

  int tile_count() const { return static_cast<int>(tiles.size()); }
};

LayoutTile make_layout_tile(const TileMesh& tiles, int tile);

// Model with the gaps of contacts. geometry must outlive it.
LayoutModel make_layout_model(const DesignGeometry& geometry, const Parameters& parameters);

// Keep `separation.other` beyond the edge of `separation.tile`, all three corners on both sides.
void add_separation(LayoutModel& model, const Separation& separation);

FlatPoses poses_of(const LayoutModel& model, const LayoutState& state);
Array6 insets_of(const LayoutState& state);
LayoutState state_of(const LayoutModel& model, const FlatPoses& poses, const Array6& q);

}  // namespace curveups
