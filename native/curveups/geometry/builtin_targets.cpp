// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/builtin_targets.hpp"

#include <algorithm>
#include <cmath>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/lifted_region.hpp"

namespace curveups {
namespace {

constexpr double pi = 3.14159265358979323846;

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
