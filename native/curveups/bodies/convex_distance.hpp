// SPDX-License-Identifier: LGPL-2.1-or-later
// Exact distances of convex polyhedra and of the spherical caps on them.
#pragma once

#include "curveups/bodies/print_body.hpp"
#include "curveups/design/convex_body.hpp"

namespace curveups {

// Point of the body nearest to p (p itself inside).
Vec3 nearest_point(const ConvexBody& body, const Vec3& p);

// Distance of two bodies, 0 where they touch or overlap.
double distance(const ConvexBody& a, const ConvexBody& b);

// Volume of the intersection, mm3.
double common_volume(const ConvexBody& a, const ConvexBody& b);

// Sphere of a bump; the cap lies at least `flat` from the centre along the axis.
struct CapSphere {
  Vec3 centre, axis;
  double radius, flat;
  bool on_cap(const Vec3& direction) const { return axis.dot(direction) * radius >= flat; }
};
CapSphere cap_sphere(const Vec3& base_centre, const Vec3& axis, double base_radius, double height);

// Distances of caps whose base discs lie in their own convex body; negative where they overlap.
// Infinite where the spheres' nearest points are not on the caps: a body is then nearer than its
// cap.
double distance(const CapSphere& cap, const ConvexBody& body);
double distance(const CapSphere& a, const CapSphere& b);

// Moves a body rigidly.
ConvexBody moved(const ConvexBody& body, const RigidMotion& motion);

// Makes a right prism between two heights over a convex outline, counter-clockwise from above. All
// walls of the second have the tag body_tag::wall.
ConvexBody make_prism(const std::array<Vec2, 3>& outline, double z_low, double z_high);
ConvexBody make_prism(const Polygon& outline, double z_low, double z_high);

Eigen::AlignedBox3d bounding_box(const ConvexBody& body);

}  // namespace curveups
