// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/print_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace curveups {
namespace {

// Area of a polygon about `normal`, relative to its first point against cancellation.
double polygon_area(const PrintBody& body, const std::vector<int>& loop, const Vec3& normal) {
  const Vec3& o = body.points[loop[0]];
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
    sum += (body.points[loop[k]] - o).cross(body.points[loop[k + 1]] - o);
  }
  return 0.5 * sum.dot(normal);
}

double loop_area(const PrintBody& body, const BodyLoop& loop, const Vec3& normal, bool outer) {
  if (loop.circle < 0) return polygon_area(body, loop.points, normal);
  const double r = body.circles[loop.circle].radius;
  return (outer ? 1 : -1) * M_PI * r * r;
}

const Vec3& first_point(const PrintBody& body, const BodyLoop& loop) {
  return loop.circle < 0 ? body.points[loop.points[0]] : body.circles[loop.circle].centre;
}

}  // namespace

RigidMotion flat_motion(const FlatPoses& poses, int tile, double z) {
  const PlaneRotation turn(poses(tile, 2));
  RigidMotion motion;
  motion.R << turn.c, -turn.s, 0, turn.s, turn.c, 0, 0, 0, 1;
  motion.t = Vec3(poses(tile, 0), poses(tile, 1), z);
  return motion;
}

double sphere_radius(double base_radius, double height) {
  return (base_radius * base_radius + height * height) / (2 * height);
}

double face_area(const PrintBody& body, const PlanarFace& face) {
  double area = loop_area(body, face.outer, face.normal, true);
  for (const BodyLoop& loop : face.inner) area += loop_area(body, loop, face.normal, false);
  return area;
}

double volume(const PrintBody& body) {
  // Relative to a point of the body, against cancellation.
  const Vec3 origin = body.points.empty() ? body.circles.at(0).centre : body.points[0];
  double sum = 0;
  for (const PlanarFace& face : body.faces) {
    sum += face_area(body, face) * face.normal.dot(first_point(body, face.outer) - origin) / 3;
  }
  for (const SphericalCap& cap : body.caps) {
    const BodyCircle& c = body.circles[cap.circle];
    const double r = c.radius, h = cap.height, sign = cap.bump ? 1 : -1;
    // Flux of the base disc and of the space between disc and cap.
    const Vec3 outward = sign * cap.axis;
    sum += M_PI * r * r * outward.dot(c.centre - origin) / 3;
    sum += sign * M_PI * h * (3 * r * r + h * h) / 6;
  }
  for (const CylinderWall& wall : body.cylinders) {
    const BodyCircle& c = body.circles[wall.bottom];
    const double height = (body.circles[wall.top].centre - c.centre).norm();
    sum += (wall.outward ? 1 : -1) * 2 * M_PI * c.radius * c.radius * height / 3;
  }
  return sum;
}

void move(PrintBody& body, const RigidMotion& motion) {
  for (Vec3& p : body.points) p = motion(p);
  for (BodyCircle& c : body.circles) {
    c.centre = motion(c.centre);
    c.axis = motion.R * c.axis;
  }
  for (PlanarFace& face : body.faces) face.normal = motion.R * face.normal;
  for (SphericalCap& cap : body.caps) cap.axis = motion.R * cap.axis;
}

Eigen::AlignedBox3d bounding_box(const PrintBody& body) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : body.points) box.extend(p);
  for (const BodyCircle& c : body.circles) {
    const Vec3 reach = c.radius * (Vec3::Ones() - c.axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    box.extend(c.centre - reach);
    box.extend(c.centre + reach);
  }
  for (const SphericalCap& cap : body.caps) {
    if (!cap.bump) continue;
    const BodyCircle& c = body.circles[cap.circle];
    const double R = sphere_radius(c.radius, cap.height);
    const Vec3 centre = c.centre - (R - cap.height) * cap.axis;
    for (int k = 0; k < 3; ++k) {
      for (double sign : {-1.0, 1.0}) {  // the sphere's extreme point, where it is on the cap
        if (sign * cap.axis[k] * R >= R - cap.height) box.extend(centre + sign * R * Vec3::Unit(k));
      }
    }
  }
  return box;
}

std::vector<int> add_points(PrintBody& body, const Polygon& polygon, double z) {
  std::vector<int> loop;
  for (const Vec2& p : polygon) {
    loop.push_back(static_cast<int>(body.points.size()));
    body.points.emplace_back(p.x(), p.y(), z);
  }
  return loop;
}

std::vector<int> extrude(PrintBody& body, const std::vector<int>& base, const Vec3& offset,
                         FaceRole role) {
  const int n = static_cast<int>(base.size());
  std::vector<int> top(n);
  for (int k = 0; k < n; ++k) {
    top[k] = static_cast<int>(body.points.size());
    body.points.push_back(body.points[base[k]] + offset);
  }
  for (int k = 0; k < n; ++k) {
    const int l = (k + 1) % n;
    const Vec3 along = body.points[base[l]] - body.points[base[k]];
    PlanarFace face;
    face.normal = along.cross(offset).normalized();
    face.outer.points = {base[k], base[l], top[l], top[k]};
    face.role = role;
    body.faces.push_back(std::move(face));
  }
  return top;
}

std::pair<BodyLoop, BodyLoop> add_walls(PrintBody& body, const Polygon& polygon, double height) {
  const std::vector<int> base = add_points(body, polygon, 0);
  return {BodyLoop{{base.rbegin(), base.rend()}},
          BodyLoop{extrude(body, base, Vec3(0, 0, height), FaceRole::plain)}};
}

}  // namespace curveups
