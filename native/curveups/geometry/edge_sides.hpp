// SPDX-License-Identifier: LGPL-2.1-or-later
// The sides of faces that lie on each edge, for meshes of any kind and millions of faces.
#pragma once

#include <functional>

#include "curveups/core/types.hpp"

namespace curveups {

struct EdgeSide {
  int low, high;  // vertices of the edge, low < high
  int face;
  int side;  // of the face (0 to 2)
  bool up;   // the face runs from low to high
};

// Calls visit(begin, end) for every edge with its sides, in ascending order of (low, high), the
// sides in ascending order of (face, side). F: M x 3 with indices below vertex_count; sides that
// join a vertex with itself are left out. In time linear in M but for crowded vertices. Throws
// Cancelled.
void visit_edges(const Eigen::Ref<const Triangles>& F, int vertex_count,
                 const std::function<void(const EdgeSide* begin, const EdgeSide* end)>& visit);

}  // namespace curveups
