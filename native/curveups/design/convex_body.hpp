// SPDX-License-Identifier: LGPL-2.1-or-later
// The body of a tile: a convex polyhedron that planes cut in closed form.
#pragma once

#include <array>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// Points x with normal . x <= offset are kept. normal has unit length.
struct Plane {
  Vec3 normal;
  double offset;
  double distance(const Vec3& p) const { return normal.dot(p) - offset; }
};

// tag: 0 front, 1 back, 2 to 4 the walls of edges 0 to 2, 5 and more: the cutting planes in the
// order in which they were applied.
struct BodyFace {
  std::vector<int> loop;  // point indices, counter-clockwise seen from outside
  int tag;
  Plane plane;
};

struct ConvexBody {
  std::vector<Vec3> points;
  std::vector<BodyFace> faces;
};

namespace body_tag {
inline constexpr int front = 0, back = 1, wall = 2, cut = 5;
}

// The frustum between `top` at z = z_top and `bottom` at z = z_bottom < z_top, two triangles with
// parallel edges, both counter-clockwise seen from above.
ConvexBody make_frustum(const std::array<Vec2, 3>& top, double z_top,
                        const std::array<Vec2, 3>& bottom, double z_bottom);

// Remove the part beyond the plane. Corners within tolerance::snap of the plane count as on it, so
// that no sliver arises; a plane that coincides with a face cuts nothing. Returns false where
// nothing is removed; a body that vanishes has no faces.
bool clip(ConvexBody& body, const Plane& plane, int tag);

double volume(const ConvexBody& body);  // mm3, exact for the polyhedron
Vec3 centroid(const ConvexBody& body);  // of volume

}  // namespace curveups
