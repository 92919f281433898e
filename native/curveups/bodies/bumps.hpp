// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction bumps: where they stand on the interfaces, and how far the walls are recessed for them.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

// A spherical cap on a wall, in its tile's frame; the base circle lies on the (recessed) wall.
struct WallCap {
  int wall;           // 0 to 2
  Vec3 centre, axis;  // the axis points to the apex: outward for bumps, inward for dimples
  double radius, height;
  bool bump;
  int contact;
};

// An interface that carries no bumps, and why.
struct BareInterface {
  int contact;
  std::string reason;  // "edge_only", "too_small", "would_touch", "would_break_through"
};

struct BumpPlan {
  std::vector<std::vector<WallCap>> of_tile;
  Array3 recess;                 // M x 3, mm along the walls' normals
  std::vector<ConvexBody> body;  // per tile: truncated and recessed, in its frame
  std::vector<BareInterface> bare;
};

// The bumps of an interface (at least three, not on a line) are shared out between its two walls in
// turn, so that they interleave; both walls stand back by half the height, so that every apex just
// touches the wall that faces it when actuated. With "dimples" the facing wall has a hollow
// concentric with each bump, and walls meet: they stand back by xy_compensation, as bare ones do.
// Where three do not fit the diameter shrinks, to half at most; interfaces that are too small even
// so, or whose bumps would touch a neighbour in the flat layout, stay bare. Throws
// InfeasibleDesign, naming the tiles, where recessing or truncation leaves a tile without front or
// back.
BumpPlan plan_bumps(const DesignGeometry& geometry, const FlatPoses& poses,
                    const Parameters& parameters);

// Per contact the apexes of its bumps in the actuated configuration (world) where its tiles touch
// there: none where it stays bare, nor where bumps sink into dimples with clearance and the walls
// touch.
std::vector<Points3> bump_tips(const BumpPlan& plan, const TileMesh& tiles);

// How far tiles whose walls touch can slide before bumps stop at the rims of their dimples, mm, at
// the contact with the most play; 0 without dimples.
double sliding_play(const BumpPlan& plan, const TileMesh& tiles);

}  // namespace curveups
