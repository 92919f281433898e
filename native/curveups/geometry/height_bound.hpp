// SPDX-License-Identifier: LGPL-2.1-or-later
// A bound on how far a triangle is from a surface that lies over all of it as a graph of heights:
// the largest height. It is exact where both are nearly parallel, as a surface and its tiles are,
// and takes one look at each face over the triangle.
#pragma once

#include <array>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

class HeightBound {
 public:
  // The surface must outlive this. Throws Cancelled.
  explicit HeightBound(const TriangleMesh& surface);

  // No point of the triangle is farther from the surface than this, mm. face: of the surface,
  // near the triangle. Infinite where this would be above `most`, and where the surface is no graph
  // over the whole triangle as far as it hangs together with that face: it ends, folds over, has no
  // area somewhere, or more than two of its faces meet at an edge.
  double operator()(const std::array<Vec3, 3>& triangle, int face, double most) const;

 private:
  const TriangleMesh& surface_;
  Triangles beyond_;  // the face beyond each side; -1 where there is none, or several
};

}  // namespace curveups
