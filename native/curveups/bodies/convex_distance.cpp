// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/convex_distance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace curveups {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 d = b - a;
  const double length2 = d.squaredNorm();
  return length2 > 0 ? Vec3(a + std::clamp((p - a).dot(d) / length2, 0.0, 1.0) * d) : a;
}

// True if p, in the plane of the face, lies inside its loop.
bool inside_loop(const ConvexBody& body, const BodyFace& face, const Vec3& p) {
  for (std::size_t k = 0; k < face.loop.size(); ++k) {
    const Vec3& a = body.points[face.loop[k]];
    const Vec3& b = body.points[face.loop[(k + 1) % face.loop.size()]];
    if ((b - a).cross(p - a).dot(face.plane.normal) < 0) return false;
  }
  return true;
}

// Squared distance of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
double segment_distance2(const Vec3& p, const Vec3& p2, const Vec3& q, const Vec3& q2) {
  const Vec3 d1 = p2 - p, d2 = q2 - q, r = p - q;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
  double s = 0, t = 0;
  if (a <= 0 && e <= 0) return r.squaredNorm();
  if (a <= 0) {
    t = std::clamp(f / e, 0.0, 1.0);
  } else {
    const double c = d1.dot(r);
    if (e <= 0) {
      s = std::clamp(-c / a, 0.0, 1.0);
    } else {
      const double b = d1.dot(d2), denominator = a * e - b * b;
      if (denominator > 1e-14 * a * e) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
      t = (b * s + f) / e;
      if (t < 0) {
        t = 0;
        s = std::clamp(-c / a, 0.0, 1.0);
      } else if (t > 1) {
        t = 1;
        s = std::clamp((b - c) / a, 0.0, 1.0);
      }
    }
  }
  return (p + s * d1 - q - t * d2).squaredNorm();
}

bool separated_by_a_face(const ConvexBody& a, const ConvexBody& b) {
  for (const BodyFace& face : a.faces) {
    bool outside = true;
    for (const Vec3& p : b.points) outside = outside && face.plane.distance(p) > 0;
    if (outside) return true;
  }
  return false;
}

double corner_distance2(const ConvexBody& a, const ConvexBody& b) {
  double least = infinity;
  for (const Vec3& p : b.points) least = std::min(least, (nearest_point(a, p) - p).squaredNorm());
  return least;
}

}  // namespace

Vec3 nearest_point(const ConvexBody& body, const Vec3& p) {
  double least = infinity;
  Vec3 nearest = p;
  for (const BodyFace& face : body.faces) {
    const double height = face.plane.distance(p);
    if (height <= 0 || height * height >= least) continue;
    const Vec3 foot = p - height * face.plane.normal;
    if (inside_loop(body, face, foot)) {
      nearest = foot;
      least = height * height;
      continue;
    }
    for (std::size_t k = 0; k < face.loop.size(); ++k) {
      const Vec3 q = nearest_on_segment(body.points[face.loop[k]],
                                        body.points[face.loop[(k + 1) % face.loop.size()]], p);
      const double distance2 = (q - p).squaredNorm();
      if (distance2 < least) {
        least = distance2;
        nearest = q;
      }
    }
  }
  return nearest;
}

double common_volume(const ConvexBody& a, const ConvexBody& b) {
  ConvexBody rest = a;
  for (const BodyFace& face : b.faces) {
    clip(rest, face.plane, body_tag::cut);
    if (rest.faces.empty()) return 0;
  }
  return std::max(0.0, volume(rest));
}

double distance(const ConvexBody& a, const ConvexBody& b) {
  if (!separated_by_a_face(a, b) && !separated_by_a_face(b, a) && common_volume(a, b) > 0) return 0;
  double least = std::min(corner_distance2(a, b), corner_distance2(b, a));
  for (const BodyFace& f : a.faces) {
    for (std::size_t k = 0; k < f.loop.size(); ++k) {
      const int a1 = f.loop[k], a2 = f.loop[(k + 1) % f.loop.size()];
      if (a1 > a2) continue;  // every edge once
      for (const BodyFace& g : b.faces) {
        for (std::size_t l = 0; l < g.loop.size(); ++l) {
          const int b1 = g.loop[l], b2 = g.loop[(l + 1) % g.loop.size()];
          if (b1 > b2) continue;
          least = std::min(
              least, segment_distance2(a.points[a1], a.points[a2], b.points[b1], b.points[b2]));
        }
      }
    }
  }
  return std::sqrt(least);
}

CapSphere cap_sphere(const Vec3& base_centre, const Vec3& axis, double base_radius, double height) {
  const double radius = sphere_radius(base_radius, height);
  return {base_centre - (radius - height) * axis, axis, radius, radius - height};
}

double distance(const CapSphere& cap, const ConvexBody& body) {
  const Vec3 to = nearest_point(body, cap.centre) - cap.centre;
  const double length = to.norm();
  if (length <= 0) return -cap.radius;
  return cap.on_cap(to / length) ? length - cap.radius : infinity;
}

double distance(const CapSphere& a, const CapSphere& b) {
  const Vec3 to = b.centre - a.centre;
  const double length = to.norm();
  if (length <= 0) return -a.radius - b.radius;
  if (!a.on_cap(to / length) || !b.on_cap(-to / length)) return infinity;
  return length - a.radius - b.radius;
}

ConvexBody moved(const ConvexBody& body, const RigidMotion& motion) {
  ConvexBody out = body;
  for (Vec3& p : out.points) p = motion(p);
  for (BodyFace& face : out.faces) {
    face.plane.normal = motion.R * face.plane.normal;
    face.plane.offset += face.plane.normal.dot(motion.t);
  }
  return out;
}

ConvexBody make_prism(const std::array<Vec2, 3>& outline, double z_low, double z_high) {
  return make_frustum(outline, z_high, outline, z_low);
}

ConvexBody make_prism(const Polygon& outline, double z_low, double z_high) {
  ConvexBody body;
  BodyFace bottom{{}, body_tag::back, {-Vec3::UnitZ(), -z_low}};
  BodyFace top{{}, body_tag::front, {Vec3::UnitZ(), z_high}};
  const int n = static_cast<int>(outline.size());
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    for (double z : {z_low, z_high}) {
      body.points.emplace_back(outline[i].x(), outline[i].y(), z);
    }
    bottom.loop.insert(bottom.loop.begin(), 2 * i);
    top.loop.push_back(2 * i + 1);
    const Vec2 out = -left_of(outline[j] - outline[i]).normalized();
    body.faces.push_back({{2 * i, 2 * j, 2 * j + 1, 2 * i + 1},
                          body_tag::wall,
                          {Vec3(out.x(), out.y(), 0), out.dot(outline[i])}});
  }
  body.faces.push_back(std::move(bottom));
  body.faces.push_back(std::move(top));
  return body;
}

Eigen::AlignedBox3d bounding_box(const ConvexBody& body) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : body.points) box.extend(p);
  return box;
}

}  // namespace curveups
