// SPDX-License-Identifier: LGPL-2.1-or-later
// The planar interfaces at which tiles touch when actuated (paper, section 4 and A.2).
#pragma once

#include <array>
#include <vector>

#include "curveups/design/truncation.hpp"

namespace curveups {

// Interface of tiles.contacts[k]. Points in actuated world coordinates: 0 and 1 are the ends of the
// front edge as tile[0] runs along it, 2 and 3 the back ends, 2 below 1 and 3 below 0.
struct ContactPatch {
  std::array<Vec3, 4> point;
  int point_count;  // 4; 3 where the back segment is shorter than tolerance::short_interface (its
                    // midpoint is point 2); 2: nothing but the front edge touches, a hinge
  Vec3 normal;      // unit, from tile[0] to tile[1]; a compressive force on tile[1] points along it
  std::vector<Vec3> polygon;  // common part of both walls, counter-clockwise seen from tile[1]
};

std::vector<ContactPatch> compute_contact_patches(const TileMesh& tiles,
                                                  const Truncation& truncation);

// Clip an interface by a plane of one of its tiles (world coordinates) that leaves the front edge
// alone; the contact points move to the new corners.
void clip_patch(ContactPatch& patch, const Plane& plane);

}  // namespace curveups
