// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangulation of a surface that is given by a formula over a region of the plane.
#pragma once

#include <functional>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct LiftedRegion {
  // Position of the surface over a point of the plane; counter-clockwise in the plane is
  // counter-clockwise seen from the front.
  std::function<Vec3(const Vec2&)> lift;
  // Negative inside the region, zero on its smooth outlines, holes included.
  std::function<double(const Vec2&)> outside;
  double reach;  // the region lies in |x| <= reach, |y| <= reach
};

// Vertices lie on the surface and boundary vertices on the outline to rounding; faces stay within
// about `tolerance` (mm, in the unit of the plane as of the surface) of the surface.
TriangleMesh triangulate(const LiftedRegion& region, double tolerance);

}  // namespace curveups
