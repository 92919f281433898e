// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/body_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"

namespace curveups {
namespace {

struct Basis {
  Vec3 u, v;
};

// u x v = n; the coordinate axes for axis-parallel normals, so that nothing is rounded there.
Basis basis_of(const Vec3& n) {
  const Vec3 u = std::abs(n.z()) > 0.999 ? Vec3(Vec3::UnitX() - n.x() * n).normalized()
                                         : Vec3(-n.y(), n.x(), 0).normalized();
  return {u, n.cross(u)};
}

// Least number of segments of a full circle whose chords stay within the deviation.
int segments(double radius, double deviation) {
  const double c = std::max(0.0, 1 - deviation / radius);
  return std::clamp(static_cast<int>(std::ceil(M_PI / std::acos(c))), 8, 720);
}

// Circumradius over radius of the regular polygon with a circle's area. Its corners and chords are
// nearer to the circle than chords between corners on the circle.
double equal_area_scale(int corners) {
  const double angle = 2 * M_PI / corners;
  return std::sqrt(angle / std::sin(angle));
}

class Mesher {
 public:
  Mesher(const PrintBody& body, const MeshingOptions& options) : body_(body), options_(options) {
    mesh_.name = body.name;
    mesh_.kind = body.kind;
    mesh_.piece = body.piece;
    point_.assign(body.points.size(), -1);
    ring_.resize(body.circles.size());
    flat_.assign(body.circles.size(), 0);
    if (!options.caps) {
      for (const SphericalCap& cap : body.caps) flat_[cap.circle] = 1;
    }
    // Cylinder walls join points of the same angle: both circles take one axis and count.
    for (const CylinderWall& wall : body.cylinders) {
      for (int circle : {wall.bottom, wall.top}) {
        make_ring(circle, body.circles[wall.bottom].axis, equal_area_scale(corners_of(circle)));
      }
    }
    for (const SphericalCap& cap : body.caps) {
      if (options.caps) make_ring(cap.circle, cap.axis, 1);
    }
  }

  BodyMesh run() {
    for (const PlanarFace& face : body_.faces) add_face(face);
    for (const CylinderWall& wall : body_.cylinders) add_cylinder(wall);
    if (options_.caps) {
      for (const SphericalCap& cap : body_.caps) add_cap(cap);
    }
    return std::move(mesh_);
  }

 private:
  int add_point(const Vec3& p) {
    mesh_.points.push_back(p);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  // Counter-clockwise about the axis.
  std::vector<int> ring_points(const Vec3& centre, const Vec3& axis, double radius, int count) {
    const Basis b = basis_of(axis);
    std::vector<int> ring(count);
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * M_PI * k / count;
      ring[k] = add_point(centre + radius * (std::cos(angle) * b.u + std::sin(angle) * b.v));
    }
    return ring;
  }

  int corners_of(int circle) const {
    return segments(body_.circles[circle].radius, options_.deviation);
  }

  void make_ring(int circle, const Vec3& axis, double scale) {
    const BodyCircle& c = body_.circles[circle];
    ring_[circle] = ring_points(c.centre, axis, scale * c.radius, corners_of(circle));
  }

  std::vector<int> loop_points(const BodyLoop& loop) {
    if (loop.circle >= 0) return ring_[loop.circle];
    std::vector<int> out;
    for (int i : loop.points) {
      if (point_[i] < 0) point_[i] = add_point(body_.points[i]);
      out.push_back(point_[i]);
    }
    return out;
  }

  void add_face(const PlanarFace& face) {
    std::vector<std::vector<int>> loops{loop_points(face.outer)};
    for (const BodyLoop& loop : face.inner) {
      if (loop.circle >= 0 && flat_[loop.circle]) continue;
      loops.push_back(loop_points(loop));
    }
    if (loops.size() == 1 && loops[0].size() == 3) {
      mesh_.triangles.push_back({loops[0][0], loops[0][1], loops[0][2]});
      return;
    }
    const Basis b = basis_of(face.normal);
    std::vector<Vec2> points;
    std::vector<int> global;
    for (std::vector<int>& loop : loops) {
      for (int& i : loop) {
        points.emplace_back(b.u.dot(mesh_.points[i]), b.v.dot(mesh_.points[i]));
        global.push_back(i);
        i = static_cast<int>(points.size()) - 1;
      }
    }
    for (const auto& t : triangulate_region(points, loops)) {
      mesh_.triangles.push_back({global[t[0]], global[t[1]], global[t[2]]});
    }
  }

  // The band between two rings, both counter-clockwise about the direction from a to b.
  void add_band(const std::vector<int>& a, const std::vector<int>& b, bool outward) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      const std::size_t l = (k + 1) % a.size();
      add_triangle(a[k], a[l], b[l], outward);
      add_triangle(a[k], b[l], b[k], outward);
    }
  }

  void add_triangle(int a, int b, int c, bool outward) {
    if (!outward) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  void add_cylinder(const CylinderWall& wall) {
    const Vec3 up = body_.circles[wall.top].centre - body_.circles[wall.bottom].centre;
    const bool along = up.dot(body_.circles[wall.bottom].axis) > 0;
    add_band(ring_[wall.bottom], ring_[wall.top], wall.outward == along);
  }

  void add_cap(const SphericalCap& cap) {
    const BodyCircle& c = body_.circles[cap.circle];
    const double R = sphere_radius(c.radius, cap.height);
    const double opening = std::acos(std::clamp((R - cap.height) / R, -1.0, 1.0));
    const double step = 2 * std::acos(std::max(0.0, 1 - options_.deviation / R));
    const int rings = std::max(1, static_cast<int>(std::ceil(opening / step)));
    const Vec3 centre = c.centre - (R - cap.height) * cap.axis;
    std::vector<int> below = ring_[cap.circle];
    for (int k = 1; k < rings; ++k) {
      const double polar = opening * (rings - k) / rings;
      std::vector<int> above = ring_points(centre + R * std::cos(polar) * cap.axis, cap.axis,
                                           R * std::sin(polar), static_cast<int>(below.size()));
      add_band(below, above, cap.bump);
      below = std::move(above);
    }
    const int apex = add_point(c.centre + cap.height * cap.axis);
    for (std::size_t k = 0; k < below.size(); ++k) {
      add_triangle(below[k], below[(k + 1) % below.size()], apex, cap.bump);
    }
  }

  const PrintBody& body_;
  const MeshingOptions& options_;
  BodyMesh mesh_;
  std::vector<int> point_;              // mesh point of a body point
  std::vector<std::vector<int>> ring_;  // mesh points of a circle
  std::vector<char> flat_;              // circles that are left out
};

}  // namespace

BodyMesh mesh_body(const PrintBody& body, const MeshingOptions& options) {
  return Mesher(body, options).run();
}

std::vector<BodyMesh> mesh_bodies(const std::vector<const PrintBody*>& bodies,
                                  const MeshingOptions& options) {
  std::vector<BodyMesh> meshes(bodies.size());
  checkpoint("meshing bodies", 0);
  parallel_each(static_cast<int>(bodies.size()),
                [&](int i) { meshes[i] = mesh_body(*bodies[i], options); });
  return meshes;
}

}  // namespace curveups
