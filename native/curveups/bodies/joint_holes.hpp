// SPDX-License-Identifier: LGPL-2.1-or-later
// Stitching holes along the borders of pieces.
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
  std::vector<Joint> joints;                    // empty with joint=none
  std::vector<int> closed;                      // joints without room for a hole on both sides
};

// Plans one hole on either side of each joint, two where its edge is at least 12 mm long, at the
// same places along the edge: joint_depth from the border, in the middle of the edge (a quarter
// from either end) or as near to there as other walls and truncation planes allow. At every height
// p_floor of material remains to every wall, recessed and hollowed by `bumps`, truncation plane,
// pin and hole.
JointHoles plan_joint_holes(const DesignGeometry& geometry, const BumpPlan& bumps, const Array6& q,
                            const Parameters& parameters);

// Bores holes into a tile's body, moved from its frame by `motion`: circles in its front and back
// face and cylinders between them.
void bore(PrintBody& body, const std::vector<JointHole>& holes, double radius, double H_body,
          const RigidMotion& motion);

}  // namespace curveups
