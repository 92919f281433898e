// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact distances of convex polyhedra and of the spherical caps on them.
#pragma once

#include "curveups/bodies/print_body.hpp"
#include "curveups/design/convex_body.hpp"

namespace curveups {

// The point of the body that is nearest to p (p itself inside).
Vec3 nearest_point(const ConvexBody& body, const Vec3& p);

// 0 where the bodies touch or overlap.
double distance(const ConvexBody& a, const ConvexBody& b);

// mm3 that two convex bodies have in common.
double common_volume(const ConvexBody& a, const ConvexBody& b);

// A bump's sphere: the cap is what lies at least `flat` from the centre along the axis.
struct CapSphere {
  Vec3 centre, axis;
  double radius, flat;
  bool on_cap(const Vec3& direction) const { return axis.dot(direction) * radius >= flat; }
};
CapSphere cap_sphere(const Vec3& base_centre, const Vec3& axis, double base_radius, double height);

// Distances of caps whose base discs lie in their own convex body. Where the spheres' nearest
// points are not on the caps, a base disc is nearer than the cap, and so is the body: the result is
// then infinite and the bodies' own distance counts. Negative where they overlap.
double distance(const CapSphere& cap, const ConvexBody& body);
double distance(const CapSphere& a, const CapSphere& b);

// The body moved rigidly.
ConvexBody moved(const ConvexBody& body, const RigidMotion& motion);

// A right prism between two heights, outline convex and counter-clockwise seen from above. The tag
// of all walls of the second is body_tag::wall.
ConvexBody make_prism(const std::array<Vec2, 3>& outline, double z_low, double z_high);
ConvexBody make_prism(const Polygon& outline, double z_low, double z_high);

Box bounding_box(const ConvexBody& body);

}  // namespace curveups
