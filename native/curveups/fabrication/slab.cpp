// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/slab.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"

namespace curveups {
namespace {

bool surrounded(FaceRole role) {
  return role == FaceRole::wall || role == FaceRole::cut || role == FaceRole::back ||
         role == FaceRole::back_pin;
}

void add_cavity(PrintBody& slab, PlanarFace& bottom, PlanarFace& lid, const PrintBody& body,
                double top) {
  const int points = static_cast<int>(slab.points.size());
  const int circles = static_cast<int>(slab.circles.size());
  slab.points.insert(slab.points.end(), body.points.begin(), body.points.end());
  slab.circles.insert(slab.circles.end(), body.circles.begin(), body.circles.end());
  const auto reversed = [&](BodyLoop loop) {
    for (int& i : loop.points) i += points;
    std::reverse(loop.points.begin(), loop.points.end());
    if (loop.circle >= 0) loop.circle += circles;
    return loop;
  };
  for (const PlanarFace& face : body.faces) {
    if (face.role == FaceRole::foot) {
      bottom.inner.push_back(reversed(face.outer));
    } else if (face.role == FaceRole::front) {
      BodyLoop mouth = reversed(face.outer);
      const double rise = top - slab.points[mouth.points[0]].z();
      if (rise > tolerance::snap) {
        mouth.points = extrude(slab, mouth.points, Vec3(0, 0, rise), FaceRole::plain);
      }
      lid.inner.push_back(std::move(mouth));
    } else if (surrounded(face.role)) {
      PlanarFace wall;
      wall.normal = -face.normal;
      wall.outer = reversed(face.outer);
      for (const BodyLoop& loop : face.inner) wall.inner.push_back(reversed(loop));
      slab.faces.push_back(std::move(wall));
    }
  }
  for (const SphericalCap& cap : body.caps) {
    slab.caps.push_back({cap.circle + circles, cap.axis, cap.height, !cap.bump});
  }
}

// Axes of the face's plane, seen from outside.
struct PlaneAxes {
  Vec3 u, v;
  explicit PlaneAxes(const Vec3& normal) : u(normal.unitOrthogonal()), v(normal.cross(u)) {}
  Vec2 operator()(const Vec3& p) const { return {u.dot(p), v.dot(p)}; }
};

// Distance from a circle to the nearest other loop of the face; at most its radius.
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

// Adds the face between a circle and a regular polygon around it; returns the polygon as the hole
// of `face` in the circle's place.
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

// Adds `face`, whose outer loop is a polygon of `body`, as triangles over the body's own points:
// OpenCASCADE compares the holes of a face pair by pair, minutes for a slab. Circles among the
// holes keep a narrow ring, the only faces with a hole; its polygon is of new points.
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
    checkpoint();
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

}  // namespace

PrintBody make_slab(const std::vector<Polygon>& outline, const std::vector<PrintBody>& cavities,
                    const std::vector<Vec2>& bores, double bore_radius, double top) {
  PrintBody slab;
  slab.kind = BodyKind::support;
  PlanarFace bottom, lid;
  bottom.normal = -Vec3::UnitZ();
  lid.normal = Vec3::UnitZ();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    auto [below, above] = add_walls(slab, outline[k], top);
    (k == 0 ? lid.outer : lid.inner.emplace_back()) = std::move(above);
    (k == 0 ? bottom.outer : bottom.inner.emplace_back()) = std::move(below);
  }
  for (const PrintBody& body : cavities) {
    checkpoint();
    add_cavity(slab, bottom, lid, body, top);
  }
  for (const Vec2& bore : bores) {
    const Vec3 foot(bore.x(), bore.y(), 0);
    BodyLoop below, above;
    below.circle = static_cast<int>(slab.circles.size());
    slab.circles.push_back({foot, Vec3::UnitZ(), bore_radius});
    above.circle = below.circle + 1;
    slab.circles.push_back({foot + Vec3(0, 0, top), Vec3::UnitZ(), bore_radius});
    slab.cylinders.push_back({below.circle, above.circle, false});
    bottom.inner.push_back(std::move(below));
    lid.inner.push_back(std::move(above));
  }
  checkpoint("dividing the support's underside", 0.7);
  add_divided(slab, bottom);
  checkpoint("dividing the support's lid", 0.8);
  add_divided(slab, lid);
  return slab;
}

}  // namespace curveups
