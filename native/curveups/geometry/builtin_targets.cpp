// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/builtin_targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"

namespace curveups {

// Surface given by a formula over a region of the plane.
struct LiftedRegion {
  // Position of the surface over a point of the plane. Counter-clockwise in the plane is
  // counter-clockwise seen from the front.
  std::function<Vec3(const Vec2&)> lift;
  // Negative inside the region, zero on its smooth outlines, holes included.
  std::function<double(const Vec2&)> outside;
  double reach;  // largest |x| and |y| in the region
};

namespace {

constexpr double pi = 3.14159265358979323846;

// Outlines curve more than surfaces do: their chords keep the tolerance down to this radius, mm.
constexpr double outline_radius = 40;

Vec2 gradient(const LiftedRegion& region, const Vec2& p) {
  const double d = 1e-6 * region.reach;
  const Vec2 x(d, 0), y(0, d);
  return Vec2(region.outside(p + x) - region.outside(p - x),
              region.outside(p + y) - region.outside(p - y)) /
         (2 * d);
}

// Largest normal component of the second derivative of the lift, sampled in three directions.
double largest_bend(const LiftedRegion& region) {
  const int samples = 100;
  const double d = 1e-3 * region.reach;
  double bend = 0;
  for (int j = 0; j <= samples; ++j) {
    for (int i = 0; i <= samples; ++i) {
      const Vec2 p(region.reach * (2.0 * i / samples - 1), region.reach * (2.0 * j / samples - 1));
      if (region.outside(p) > 0) continue;
      const Vec3 x = region.lift(p + Vec2(d, 0)) - region.lift(p - Vec2(d, 0));
      const Vec3 y = region.lift(p + Vec2(0, d)) - region.lift(p - Vec2(0, d));
      const Vec3 normal = x.cross(y).normalized();
      for (const Vec2& step : {Vec2(d, 0), Vec2(d / 2, 0.866 * d), Vec2(-d / 2, 0.866 * d)}) {
        const Vec3 second =
            (region.lift(p + step) - 2 * region.lift(p) + region.lift(p - step)) / (d * d);
        bend = std::max(bend, std::abs(second.dot(normal)));
      }
    }
  }
  return bend;
}

// A grid of equilateral triangles, cut along the outline. Grid points near the outline are moved
// onto it first, so that no slivers arise.
class ClippedGrid {
 public:
  ClippedGrid(const LiftedRegion& region, double spacing) : region_(region) {
    const double height = spacing * std::sqrt(0.75);
    const int columns = static_cast<int>(std::ceil(2 * region.reach / spacing)) + 4;
    const int rows = static_cast<int>(std::ceil(2 * region.reach / height)) + 4;
    for (int j = 0; j < rows; ++j) {
      for (int i = 0; i < columns; ++i) {
        add_grid_point(
            Vec2((i - 0.5 * columns + (j % 2 ? 0.5 : 0.0)) * spacing, (j - 0.5 * rows) * height),
            spacing);
      }
    }
    for (int j = 0; j + 1 < rows; ++j) {
      for (int i = 0; i + 1 < columns; ++i) {
        const int a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
        if (j % 2) {
          add_triangle({a, b, d});
          add_triangle({a, d, c});
        } else {
          add_triangle({a, b, c});
          add_triangle({b, d, c});
        }
      }
    }
  }

  // Only the vertices that faces use, in the order of their use.
  TriangleMesh mesh() const {
    TriangleMesh whole{Points3(points_.size(), 3), Triangles(faces_.size(), 3)};
    for (std::size_t v = 0; v < points_.size(); ++v) whole.V.row(v) = region_.lift(points_[v]);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      whole.F.row(f) << faces_[f][0], faces_[f][1], faces_[f][2];
    }
    return parts_of(whole, std::vector<int>(faces_.size(), 0)).at(0).mesh;
  }

 private:
  void add_grid_point(Vec2 p, double spacing) {
    double value = region_.outside(p);
    Vec2 slope = gradient(region_, p);
    if (slope.norm() > 0 && std::abs(value) < 0.3 * spacing * slope.norm()) {
      for (int k = 0; k < 20; ++k) {
        p -= value / slope.squaredNorm() * slope;
        value = region_.outside(p);
        slope = gradient(region_, p);
        if (std::abs(value) < 1e-13 * slope.norm() * region_.reach) break;
      }
      value = 0;
    }
    points_.push_back(p);
    side_.push_back(value < 0 ? -1 : value > 0 ? 1 : 0);
  }

  int crossing(int a, int b) {  // between a point inside and one outside
    if (side_[a] > 0) std::swap(a, b);
    const auto [it, fresh] =
        crossings_.emplace(std::minmax(a, b), static_cast<int>(points_.size()));
    if (fresh) {
      Vec2 in = points_[a], out = points_[b];
      for (int k = 0; k < 60; ++k) {
        const Vec2 middle = 0.5 * (in + out);
        (region_.outside(middle) < 0 ? in : out) = middle;
      }
      points_.push_back(0.5 * (in + out));
      side_.push_back(0);
    }
    return it->second;
  }

  void add_triangle(const std::array<int, 3>& corner) {
    std::vector<int> polygon;
    bool inside = false;
    for (int t = 0; t < 3; ++t) {
      const int a = corner[t], b = corner[next3(t)];
      if (side_[a] <= 0) polygon.push_back(a);
      inside = inside || side_[a] < 0;
      if (side_[a] * side_[b] < 0) polygon.push_back(crossing(a, b));
    }
    if (!inside && polygon.size() == 3) {
      const Vec2 middle = (points_[corner[0]] + points_[corner[1]] + points_[corner[2]]) / 3;
      inside = region_.outside(middle) < 0;
    }
    if (!inside || polygon.size() < 3) return;
    if (polygon.size() == 4 && (points_[polygon[0]] - points_[polygon[2]]).squaredNorm() >
                                   (points_[polygon[1]] - points_[polygon[3]]).squaredNorm()) {
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      faces_.push_back({polygon[0], polygon[k - 1], polygon[k]});
    }
  }

  const LiftedRegion& region_;
  std::vector<Vec2> points_;
  std::vector<int> side_;  // -1 inside, 0 on the outline, 1 outside
  std::map<std::pair<int, int>, int> crossings_;
  std::vector<std::array<int, 3>> faces_;
};

// Vertices lie on the surface, boundary vertices on the outline; faces stay within about
// `tolerance` (mm) of the surface.
TriangleMesh triangulate(const LiftedRegion& region, double tolerance) {
  // A triangle of side h over a parabola of curvature k is off by h^2 k / 6 at most, a chord by a
  // factor 6 / 8 less; along the outline triangles are up to a sixth larger.
  const double bend = std::max(largest_bend(region), 0.75 / outline_radius);
  return ClippedGrid(region, std::sqrt(4.4 * tolerance / bend)).mesh();
}

// A superellipse of exponent 4: a rectangle with generous corners.
double rounded_rectangle(const Vec2& p, double a, double b) {
  return std::pow(std::pow(p.x() / a, 4) + std::pow(p.y() / b, 4), 0.25) - 1;
}

double bell(double x, double y) { return std::exp(-x * x - y * y); }

// Directions on a sphere at arc length |p| / radius from the pole.
Vec3 direction(const Vec2& p, double radius) {
  const double angle = p.norm() / radius;
  const double share = angle > 1e-9 ? std::sin(angle) / angle / radius : 1 / radius;
  return {share * p.x(), share * p.y(), std::cos(angle)};
}

LiftedRegion half_sphere() {
  const double radius = 48;
  return {[=](const Vec2& p) -> Vec3 { return radius * direction(p, radius); },
          [=](const Vec2& p) { return p.norm() - radius * pi / 2; }, 76};
}

LiftedRegion hyperboloid() {
  const double waist = 45, slope = 60;
  return {[=](const Vec2& p) -> Vec3 {
            const double angle = p.x() / waist;
            const double r = waist * std::sqrt(1 + std::pow(p.y() / slope, 2));
            return {r * std::cos(angle), r * std::sin(angle), p.y()};
          },
          [](const Vec2& p) { return rounded_rectangle(p, 58, 52); }, 59};
}

LiftedRegion saddle() {
  return {[](const Vec2& p) -> Vec3 {
            return {p.x(), p.y(), (p.x() * p.x() - p.y() * p.y()) / 130};
          },
          [](const Vec2& p) { return p.norm() - 64; }, 65};
}

LiftedRegion ellipsoid_cap() {
  const double scale = 60;
  return {[=](const Vec2& p) -> Vec3 { return direction(p, scale).cwiseProduct(Vec3(76, 58, 42)); },
          [=](const Vec2& p) { return p.norm() - scale * 75 * pi / 180; }, 80};
}

// Half of a fluted, waisted tower that turns as it rises.
LiftedRegion tower() {
  return {[](const Vec2& p) -> Vec3 {
            const double z = p.y(), h = z / 95;
            const double turn = 0.55 * h, angle = p.x() / 46;
            const double r =
                (43 + 9 * h * h - 3 * h) * (1 + 0.09 * std::cos(3 * (angle - 0.5 * h)));
            return {r * std::cos(angle + turn), r * std::sin(angle + turn), z};
          },
          [](const Vec2& p) { return rounded_rectangle(p, 84, 92); }, 94};
}

LiftedRegion mask() {
  const auto eye = [](double x, double y) {
    const double tilt = 0.2, u = x - 28, v = y - 14;
    return std::hypot((u * std::cos(tilt) + v * std::sin(tilt)) / 17,
                      (v * std::cos(tilt) - u * std::sin(tilt)) / 10.5);
  };
  return {[](const Vec2& p) -> Vec3 {
            const double x = p.x(), y = p.y();
            double z = 44 * std::cos(std::min(1.0, std::hypot(x / 66, y / 88)) * 1.1);
            z += 11 * bell(x / 19, (y + 9) / 27);  // nose
            z += 5 * (bell((x - 27) / 22, (y - 37) / 17) + bell((x + 27) / 22, (y - 37) / 17));
            z += 5 * (bell((x - 34) / 21, (y + 20) / 21) + bell((x + 34) / 21, (y + 20) / 21));
            z += 5 * bell(x / 26, (y + 52) / 14);  // mouth
            z += 4 * bell(x / 22, (y + 78) / 18);  // chin
            return {x, y, z};
          },
          [eye](const Vec2& p) {
            const double taper = 1 + 0.12 * p.y() / 88;  // narrower at the chin
            const double face = std::hypot(p.x() / (62 * taper), p.y() / 84) - 1;
            const double holes = std::min(eye(p.x(), p.y()), eye(-p.x(), p.y()));
            return std::max(face, (1 - holes) * 0.2);
          },
          90};
}

// A crown that runs out into a brim, drawn forward to a peak.
LiftedRegion cap() {
  const double radius = 72, height = 46;
  return {[=](const Vec2& p) -> Vec3 {
            const double r = p.norm();
            const double crown = r < radius ? 0.5 * height * (1 + std::cos(pi * r / radius)) : 0;
            const double forward = std::max(0.0, p.x() - 40);
            return {p.x(), p.y(), crown - forward * forward * 0.003 - p.y() * p.y() * 0.0012};
          },
          [](const Vec2& p) {
            const double x = p.x() - 8;  // an egg, its blunt end at the back
            return std::hypot(x / 92, p.y() / (82 - 0.10 * x)) - 1;
          },
          104};
}

LiftedRegion disc() {
  return {[](const Vec2& p) -> Vec3 {
            return {p.x(), p.y(), 0};
          },
          [](const Vec2& p) { return p.norm() - 60; }, 61};
}

LiftedRegion cylinder_patch() {
  const double radius = 42;
  return {[=](const Vec2& p) -> Vec3 {
            return {radius * std::sin(p.x() / radius), p.y(), radius * std::cos(p.x() / radius)};
          },
          [](const Vec2& p) { return rounded_rectangle(p, 62, 50); }, 63};
}

}  // namespace

const std::vector<BuiltinTarget>& builtin_targets() {
  static const std::vector<BuiltinTarget> list = {
      {"half-sphere", "half of a sphere of radius 48 mm, as in the paper", half_sphere},
      {"hyperboloid", "a patch of a one-sheeted hyperboloid: negative curvature", hyperboloid},
      {"saddle", "a round piece of a hyperbolic paraboloid", saddle},
      {"ellipsoid-cap", "the top of an ellipsoid with three different axes", ellipsoid_cap},
      {"tower", "a fluted architectural shell that turns as it rises", tower},
      {"mask", "a face in relief with two holes for the eyes", mask},
      {"cap", "a round crown with a brim", cap},
      {"disc", "flat: nothing rises", disc},
      {"cylinder-patch", "curved in one direction only: developable", cylinder_patch},
  };
  return list;
}

TriangleMesh builtin_target(const std::string& name, double tolerance) {
  if (!(tolerance >= 1e-4 && tolerance <= 1)) {
    throw InvalidInput("a tolerance of " + std::to_string(tolerance) + " mm is out of range",
                       "give 0.0001 to 1 mm");
  }
  std::string names;
  for (const BuiltinTarget& target : builtin_targets()) {
    if (target.name == name) return triangulate(target.region(), tolerance);
    names += (names.empty() ? "" : ", ") + target.name;
  }
  throw InvalidInput("there is no built-in target \"" + name + "\"", "choose one of " + names);
}

}  // namespace curveups
