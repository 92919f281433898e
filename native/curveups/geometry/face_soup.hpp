// SPDX-License-Identifier: LGPL-2.1-or-later
// Faces that need not be a manifold, by the millions: sides at each edge, repeated faces,
// orientation.
#pragma once

#include <functional>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// Side `side` (0 to 2) of a face.
struct EdgeSide {
  int low, high;  // vertices, low < high
  int face, side;
  bool up;  // the face runs from low to high
};

// Calls visit(begin, end) for every edge with its sides, in ascending order of (low, high), the
// sides in ascending order of (face, side). Sides that join a vertex with itself are left out.
// Throws Cancelled.
void visit_edges(const Eigen::Ref<const Triangles>& F,
                 const std::function<void(const EdgeSide* begin, const EdgeSide* end)>& visit);

// Rows of faces whose three vertices an earlier face has, in any order; ascending. Faces that use a
// vertex twice are left out. Throws Cancelled.
std::vector<int> repeated_faces(const Eigen::Ref<const Triangles>& F);

struct Orientation {
  std::vector<char> turn;  // per face: whether it is to be turned over
  bool consistent = true;  // else the surface has one side only
};

// Turns faces across edges of two faces so that neighbours agree; each component keeps the
// orientation of its larger area. Throws Cancelled.
Orientation orientation_of(const Points3& V, const Eigen::Ref<const Triangles>& F);

}  // namespace curveups
