// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/tile_print.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "curveups/bodies/convex_distance.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {
namespace {

// The front or back face as a polygon seen from above, counter-clockwise.
Polygon outline(const ConvexBody& body, int tag) {
  Polygon polygon;
  for (const BodyFace& face : body.faces) {
    if (face.tag != tag) continue;
    for (int i : face.loop) polygon.push_back(body.points[i].head<2>());
  }
  if (tag == body_tag::back) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon pin_outline(const TileMesh& tiles, const double* q, int tile, Side side) {
  const std::array<Vec2, 3> corners = pin_corners(tiles, tile, side, q);
  return Polygon(corners.begin(), corners.end());
}

// Least distance from the pin's corners to the edges of its face, negative where one is outside.
double rim_width(const Polygon& face, const Polygon& pin) {
  double least = 1e300;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec2 &a = face[k], &b = face[(k + 1) % face.size()];
    if ((b - a).norm() < tolerance::snap) continue;
    const Vec2 inward = left_of(b - a).normalized();
    for (const Vec2& p : pin) least = std::min(least, inward.dot(p - a));
  }
  return least;
}

double inscribed_diameter(const Polygon& triangle) {
  double perimeter = 0;
  for (int k = 0; k < 3; ++k) perimeter += (triangle[(k + 1) % 3] - triangle[k]).norm();
  return 4 * area(triangle) / perimeter;
}

CapSphere sphere_of(const WallCap& cap) {
  return cap_sphere(cap.centre, cap.axis, cap.radius, cap.height);
}

// Depth of the hollow below the face's plane. The hollow's nearest point lies on its sphere, or
// else on its rim.
double material_below(const BodyFace& face, const WallCap& hollow) {
  const CapSphere sphere = sphere_of(hollow);
  const Vec3& n = face.plane.normal;
  if (sphere.on_cap(n)) return -face.plane.distance(sphere.centre) - sphere.radius;
  const double slope = hollow.axis.dot(n);
  return -face.plane.distance(hollow.centre) -
         hollow.radius * std::sqrt(std::max(0.0, 1 - slope * slope));
}

// Distance from a point of one hollow to another hollow.
double distance(const Vec3& p, const WallCap& hollow) {
  const CapSphere sphere = sphere_of(hollow);
  const Vec3 outwards = p - sphere.centre;
  if (sphere.on_cap(outwards.normalized())) return outwards.norm() - sphere.radius;
  const double height = hollow.axis.dot(p - hollow.centre);
  const double beside = (p - hollow.centre - height * hollow.axis).norm() - hollow.radius;
  return std::hypot(height, beside);
}

// Distance of two hollows: between their spheres, or from a rim, point by point.
double distance(const WallCap& a, const WallCap& b) {
  constexpr int points = 64;
  double least = distance(sphere_of(a), sphere_of(b));
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Vec3 u = from->axis.unitOrthogonal(), v = from->axis.cross(u);
    for (int k = 0; k < points; ++k) {
      const PlaneRotation turn(2 * M_PI * k / points);
      least =
          std::min(least, distance(from->centre + from->radius * (turn.c * u + turn.s * v), *to));
    }
  }
  return least;
}

double least_hollow_wall(const ConvexBody& body, const std::vector<WallCap>& caps) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < caps.size(); ++k) {
    if (caps[k].bump) continue;
    for (const BodyFace& face : body.faces) {
      if (face.tag == body_tag::wall + caps[k].wall) continue;
      least = std::min(least, material_below(face, caps[k]));
    }
    for (std::size_t l = 0; l < k; ++l) {
      if (!caps[l].bump) least = std::min(least, distance(caps[k], caps[l]));
    }
  }
  return least;
}

FaceRole role_of(int tag) {
  if (tag == body_tag::front) return FaceRole::front;
  if (tag == body_tag::back) return FaceRole::back;
  return tag < body_tag::cut ? FaceRole::wall : FaceRole::cut;
}

}  // namespace

TileBodies make_tile_bodies(const Design& design) {
  TileBodies out;
  out.parameters = design.parameters;
  out.geometry = make_geometry(design.mesh, design.cuts, design.parameters);
  out.poses = fit_poses(out.geometry.tiles, design.T);
  out.q = design.q;
  out.bumps = plan_bumps(out.geometry, out.poses, out.parameters);
  check_pins(out.geometry.tiles, out.bumps.body, out.q);
  return out;
}

PrintBody make_tile_print(const TileMesh& tiles, const ConvexBody& body,
                          const std::vector<WallCap>& caps, const double* q, int tile,
                          double H_pin) {
  PrintBody out;
  out.name = tile_name(tile);
  out.tile = tile;
  out.points = body.points;
  for (const BodyFace& face : body.faces) {
    PlanarFace planar;
    planar.normal = face.plane.normal;
    planar.outer.points = face.loop;
    planar.role = role_of(face.tag);
    for (const WallCap& cap : caps) {
      if (face.tag != body_tag::wall + cap.wall) continue;
      BodyLoop circle;
      circle.circle = static_cast<int>(out.circles.size());
      out.circles.push_back({cap.centre, cap.axis, cap.radius});
      out.caps.push_back({circle.circle, cap.axis, cap.height, cap.bump});
      planar.inner.push_back(std::move(circle));
    }
    out.faces.push_back(std::move(planar));
  }
  for (Side side : {Side::front, Side::back}) {
    const bool front = side == Side::front;
    const FaceRole at = front ? FaceRole::front : FaceRole::back;
    std::vector<int> base =
        add_points(out, pin_outline(tiles, q, tile, side), front ? 0.0 : -tiles.H_body);
    // Counter-clockwise from outside; reversed as the hole of the face below the pin.
    if (!front) std::reverse(base.begin(), base.end());
    BodyLoop hole;
    hole.points.assign(base.rbegin(), base.rend());
    for (PlanarFace& face : out.faces) {
      if (face.role == at) face.inner.push_back(hole);
    }
    PlanarFace top;
    top.normal = front ? Vec3(Vec3::UnitZ()) : Vec3(-Vec3::UnitZ());
    top.outer.points =
        extrude(out, base, H_pin * top.normal, front ? FaceRole::front_pin : FaceRole::back_pin);
    top.role = front ? FaceRole::front_pin : FaceRole::foot;
    out.faces.push_back(std::move(top));
  }
  return out;
}

void check_pins(const TileMesh& tiles, const std::vector<ConvexBody>& bodies, const Array6& q) {
  std::vector<char> bad(bodies.size(), 0);
  parallel_for(static_cast<int>(bodies.size()), [&](int i) {
    for (Side side : {Side::front, Side::back}) {
      const Polygon pin = pin_outline(tiles, q.row(i).data(), i, side);
      const Polygon face =
          outline(bodies[i], side == Side::front ? body_tag::front : body_tag::back);
      const double A = pin_area(tiles, i, side, q.row(i).data());
      if (!(A > 0) || !(area(pin) > tolerance::snap) || !(rim_width(face, pin) > tolerance::snap)) {
        bad[i] = 1;
      }
    }
  });
  std::vector<int> lost;
  for (std::size_t i = 0; i < bad.size(); ++i) {
    if (bad[i]) lost.push_back(static_cast<int>(i));
  }
  if (!lost.empty()) {
    throw InfeasibleDesign("pins of " + std::to_string(lost.size()) +
                               " tiles are turned inside out or leave their face",
                           "compute the layout again with these parameters, or lower H_body", lost);
  }
}

TileFeatures tile_features(const TileMesh& tiles, const ConvexBody& body,
                           const std::vector<WallCap>& caps, const double* q, int tile) {
  const Polygon front = outline(body, body_tag::front), back = outline(body, body_tag::back);
  const Polygon front_pin = pin_outline(tiles, q, tile, Side::front);
  const Polygon back_pin = pin_outline(tiles, q, tile, Side::back);
  TileFeatures f{};
  f.front_pin = inscribed_diameter(front_pin);
  f.back_pin = inscribed_diameter(back_pin);
  f.body = std::min({tiles.H_body, width(front), width(back)});
  for (const WallCap& cap : caps) {
    if (cap.bump && (f.bump == 0 || 2 * cap.radius < f.bump)) f.bump = 2 * cap.radius;
  }
  f.hollow_wall = least_hollow_wall(body, caps);
  return f;
}

}  // namespace curveups
