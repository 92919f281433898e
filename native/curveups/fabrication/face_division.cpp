// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/face_division.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/convex_polygon.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"

namespace curveups {
namespace {

// Axes of the face's plane, seen from outside.
struct PlaneAxes {
  Vec3 u, v;
  explicit PlaneAxes(const Vec3& normal) : u(normal.unitOrthogonal()), v(normal.cross(u)) {}
  Vec2 operator()(const Vec3& p) const { return {u.dot(p), v.dot(p)}; }
};

// From a circle to the nearest other loop of the face; not more than its radius.
double clearance_around(const PrintBody& body, const PlanarFace& face, int circle,
                        const PlaneAxes& axes) {
  const Vec2 centre = axes(body.circles[circle].centre);
  const double radius = body.circles[circle].radius;
  double least = radius;
  auto look_at = [&](const BodyLoop& loop) {
    if (loop.circle >= 0 && loop.circle != circle) {
      const BodyCircle& other = body.circles[loop.circle];
      least = std::min(least, (axes(other.centre) - centre).norm() - other.radius - radius);
    }
    for (std::size_t k = 0; k < loop.points.size(); ++k) {
      const Vec2 a = axes(body.points[loop.points[k]]);
      const Vec2 b = axes(body.points[loop.points[(k + 1) % loop.points.size()]]);
      least = std::min(least, segment_distance(a, b, centre) - radius);
    }
  };
  look_at(face.outer);
  for (const BodyLoop& loop : face.inner) look_at(loop);
  return least;
}

// Adds the face between a circle and a regular polygon around it, which leaves most of the room to
// others; returns the polygon as the hole of `face` that takes the circle's place.
BodyLoop add_ring(PrintBody& body, const PlanarFace& face, const BodyLoop& hole,
                  const PlaneAxes& axes) {
  const BodyCircle& circle = body.circles[hole.circle];
  const double clearance = clearance_around(body, face, hole.circle, axes);
  if (!(clearance > tolerance::snap)) {
    throw TopologyError("the outlines of a plane face cross or touch each other",
                        "check the layout for bodies that overlap");
  }
  const double corner = circle.radius + 0.4 * clearance, side = circle.radius + 0.2 * clearance;
  const int count = std::max(6, static_cast<int>(std::ceil(M_PI / std::acos(side / corner))));
  PlanarFace ring;
  ring.normal = face.normal;
  ring.role = face.role;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * k / count;
    ring.outer.points.push_back(static_cast<int>(body.points.size()));
    body.points.push_back(circle.centre +
                          corner * (std::cos(angle) * axes.u + std::sin(angle) * axes.v));
  }
  ring.inner.push_back(hole);
  BodyLoop around;
  around.points.assign(ring.outer.points.rbegin(), ring.outer.points.rend());
  body.faces.push_back(std::move(ring));
  return around;
}

}  // namespace

void add_divided(PrintBody& body, const PlanarFace& face) {
  const PlaneAxes axes(face.normal);
  std::vector<Vec2> points;
  std::vector<int> of_body;
  std::vector<std::vector<int>> loops;
  auto add_loop = [&](const BodyLoop& loop) {
    loops.emplace_back();
    for (int i : loop.points) {
      loops.back().push_back(static_cast<int>(points.size()));
      points.push_back(axes(body.points[i]));
      of_body.push_back(i);
    }
  };
  add_loop(face.outer);
  for (const BodyLoop& loop : face.inner) {
    checkpoint();  // rings look at all other loops
    add_loop(loop.circle < 0 ? loop : add_ring(body, face, loop, axes));
  }
  for (const auto& [a, b, c] : triangulate_region(points, loops)) {
    PlanarFace part;
    part.normal = face.normal;
    part.role = face.role;
    part.outer.points = {of_body[a], of_body[b], of_body[c]};
    body.faces.push_back(std::move(part));
  }
}

}  // namespace curveups
