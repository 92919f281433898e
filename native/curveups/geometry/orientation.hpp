// SPDX-License-Identifier: LGPL-2.1-or-later
// Turning faces so that neighbours agree.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct Orientation {
  std::vector<char> turn;  // per face
  bool consistent = true;  // else the surface has one side only
};

// Goes over edges of two faces; each component keeps the orientation of its larger area. Throws
// Cancelled.
Orientation orientation_of(const Points3& V, const Eigen::Ref<const Triangles>& F);

}  // namespace curveups
