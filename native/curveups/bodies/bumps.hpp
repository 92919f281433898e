// SPDX-License-Identifier: LGPL-2.1-or-later
// Places of friction bumps on the interfaces, and recesses of the walls for them.
#pragma once

#include <string>
#include <vector>

#include "curveups/bodies/print_body.hpp"
#include "curveups/design/design.hpp"

namespace curveups {

// Spherical cap on a wall, in its tile's frame; the base circle lies on the (recessed) wall.
struct WallCap {
  int wall;           // 0 to 2
  Vec3 centre, axis;  // the axis points to the apex: outward for bumps, inward for dimples
  double radius, height;
  bool bump;
  int contact;
};

// Interface without bumps.
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

// The three bumps of an interface alternate between its two walls. Both walls are recessed by half
// the height, so that every apex touches the facing wall when actuated. With "dimples" the facing
// wall has a hollow concentric with each bump, and walls meet: they are recessed by
// xy_compensation, as bare ones are. Where bumps do not fit the diameter shrinks, to half at most;
// interfaces that are still too small, or whose bumps would touch a neighbour in the flat layout,
// stay bare. Throws InfeasibleDesign, naming the tiles, where recess or truncation leaves a tile
// without front or back.
BumpPlan plan_bumps(const DesignGeometry& geometry, const FlatPoses& poses,
                    const Parameters& parameters);

// Apexes of the bumps per contact in the actuated configuration (world), where tiles touch. Empty
// for bare contacts, and for dimples, where the walls touch.
std::vector<Points3> bump_tips(const BumpPlan& plan, const TileMesh& tiles);

// Largest slide of tiles whose walls touch before bumps stop at the rims of their dimples, mm; 0
// without dimples.
double sliding_play(const BumpPlan& plan, const TileMesh& tiles);

}  // namespace curveups
