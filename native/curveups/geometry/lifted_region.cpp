// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/lifted_region.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace curveups {
namespace {

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

  TriangleMesh mesh() const {
    std::vector<int> number(points_.size(), -1);
    TriangleMesh out;
    out.F.resize(faces_.size(), 3);
    std::vector<Vec3> positions;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (int t = 0; t < 3; ++t) {
        int& n = number[faces_[f][t]];
        if (n < 0) {
          n = static_cast<int>(positions.size());
          positions.push_back(region_.lift(points_[faces_[f][t]]));
        }
        out.F(f, t) = n;
      }
    }
    out.V.resize(positions.size(), 3);
    for (std::size_t v = 0; v < positions.size(); ++v) out.V.row(v) = positions[v];
    return out;
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

}  // namespace

TriangleMesh triangulate(const LiftedRegion& region, double tolerance) {
  // A triangle of side h over a parabola of curvature k is off by h^2 k / 6 at most, a chord by a
  // factor 6 / 8 less; along the outline triangles are up to a sixth larger.
  const double bend = std::max(largest_bend(region), 0.75 / outline_radius);
  return ClippedGrid(region, std::sqrt(4.4 * tolerance / bend)).mesh();
}

}  // namespace curveups
