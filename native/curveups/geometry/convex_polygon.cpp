// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/convex_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace curveups {
namespace {

// Outward unit normal of the edge from a to b.
Vec2 outward(const Vec2& a, const Vec2& b) { return -left_of(b - a).normalized(); }

// The part of a polygon that is at least `distance` inside of all edges of another.
Polygon within(Polygon polygon, const Polygon& other, double distance) {
  for (std::size_t k = 0; k < other.size() && !polygon.empty(); ++k) {
    const Vec2 &p = other[k], &q = other[(k + 1) % other.size()];
    if ((q - p).norm() < 1e-9) continue;
    const Vec2 n = outward(p, q);
    polygon = clip(polygon, n, n.dot(p) - distance);
  }
  return polygon;
}

}  // namespace

Polygon convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Polygon hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= start + 2 &&
             wedge(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Polygon clip(const Polygon& polygon, const Vec2& normal, double offset) {
  Polygon out;
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % n];
    const double da = normal.dot(a) - offset, db = normal.dot(b) - offset;
    if (da <= 0) out.push_back(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) out.push_back(a + da / (da - db) * (b - a));
  }
  if (out.size() < 3) out.clear();
  return out;
}

Polygon intersection(const Polygon& a, const Polygon& b) {
  return b.size() < 3 ? Polygon() : within(a, b, 0);
}

Polygon inset(const Polygon& polygon, double distance) {
  return within(polygon, polygon, distance);
}

double area(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += wedge(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
  }
  return 0.5 * sum;
}

bool contains(const Polygon& polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

double segment_distance(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const double s = d.squaredNorm() > 0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - s * d).norm();
}

double distance(const Polygon& polygon, const Vec2& p) {
  bool inside = true;
  double least = 1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (wedge(b - a, p - a) >= 0) continue;
    inside = false;
    least = std::min(least, segment_distance(a, b, p));
  }
  return inside ? 0 : least;
}

double width(const Polygon& polygon) {
  double least = 1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((b - a).norm() < 1e-9) continue;
    const Vec2 n = outward(a, b);
    double deepest = 0;
    for (const Vec2& p : polygon) deepest = std::max(deepest, n.dot(a - p));
    least = std::min(least, deepest);
  }
  return least;
}

}  // namespace curveups
