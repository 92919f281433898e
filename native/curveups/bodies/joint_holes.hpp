// SPDX-License-Identifier: LGPL-2.1-or-later
// Stitching holes along the borders of pieces: where they are, and bodies with them.
#pragma once

#include <vector>

#include "curveups/bodies/bumps.hpp"
#include "curveups/design/joints.hpp"

namespace curveups {

// A round hole through a tile from its front to its back face, square to both.
struct JointHole {
  Vec2 axis;  // in the tile's frame
  int joint;  // in JointHoles::joints
};

struct JointHoles {
  double radius = 0;                            // mm
  std::vector<std::vector<JointHole>> of_tile;  // one row per tile
  std::vector<Joint> joints;                    // all that there are; none with joint=none
  std::vector<int> closed;                      // those without room for a hole on both sides
};

// One hole on either side of each joint, two where its edge is at least 12 mm long, at the same
// places along the edge, so that a thread goes straight: as near to the border as joint_depth, in
// the middle of the edge (at a quarter from either end) or as near to there as other walls and
// truncation planes let it. Around a hole p_floor of material is left to every wall, recessed and
// hollowed as `bumps` has it, truncation plane, pin and other hole, at the front, at the back and
// in between.
JointHoles plan_joint_holes(const DesignGeometry& geometry, const BumpPlan& bumps, const Array6& q,
                            const Parameters& parameters);

// Bores holes into a tile's body, which stands where `motion` has taken it from its frame: circles
// in its front and back face, and the cylinders between them.
void bore(PrintBody& body, const std::vector<JointHole>& holes, double radius, double H_body,
          const RigidMotion& motion);

}  // namespace curveups
