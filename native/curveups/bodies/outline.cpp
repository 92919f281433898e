// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

constexpr long long most_nodes = 60'000'000;  // of the grid: 240 MB

// Negative inside the grown shapes; only needs to be right near the zero level.
struct Field {
  Vec2 origin;
  double step;
  int nx, ny;
  std::vector<float> value;
  float at(int i, int j) const { return value[static_cast<std::size_t>(j) * nx + i]; }
};

double grown_distance(const OutlineShape& shape, const Vec2& p) {
  const double d = shape.polygon.empty() ? (p - shape.disc.centre).norm() - shape.disc.radius
                                         : distance(shape.polygon, p);
  return d - shape.offset;
}

void bounds(const OutlineShape& shape, Vec2& low, Vec2& high) {
  low = high = shape.polygon.empty() ? shape.disc.centre : shape.polygon[0];
  for (const Vec2& p : shape.polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double reach = shape.offset + (shape.polygon.empty() ? shape.disc.radius : 0);
  low.array() -= reach;
  high.array() += reach;
}

Field make_field(const std::vector<OutlineShape>& shapes, double step) {
  Vec2 low(1e300, 1e300), high(-1e300, -1e300), a, b;
  for (const OutlineShape& shape : shapes) {
    bounds(shape, a, b);
    low = low.cwiseMin(a);
    high = high.cwiseMax(b);
  }
  const Vec2 size = high - low;
  while ((size.x() / step + 6) * (size.y() / step + 6) > static_cast<double>(most_nodes))
    step *= 1.5;
  Field field;
  field.step = step;
  field.origin = low - Vec2::Constant(2 * step);
  field.nx = static_cast<int>(std::ceil(size.x() / step)) + 5;
  field.ny = static_cast<int>(std::ceil(size.y() / step)) + 5;
  field.value.assign(static_cast<std::size_t>(field.nx) * field.ny, static_cast<float>(2 * step));
  for (const OutlineShape& shape : shapes) {
    bounds(shape, a, b);
    const int i0 = std::max(0, static_cast<int>((a.x() - field.origin.x()) / step) - 1);
    const int i1 = std::min(field.nx - 1, static_cast<int>((b.x() - field.origin.x()) / step) + 2);
    const int j0 = std::max(0, static_cast<int>((a.y() - field.origin.y()) / step) - 1);
    const int j1 = std::min(field.ny - 1, static_cast<int>((b.y() - field.origin.y()) / step) + 2);
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        float& value = field.value[static_cast<std::size_t>(j) * field.nx + i];
        const Vec2 p = field.origin + step * Vec2(i, j);
        value = std::min(value, static_cast<float>(grown_distance(shape, p)));
      }
    }
  }
  return field;
}

// Edges of the grid: 2 * node for the one to the right, 2 * node + 1 for the one upwards.
using EdgeId = long long;

Vec2 crossing(const Field& field, EdgeId id) {
  const long long node = id / 2;
  const int i = static_cast<int>(node % field.nx), j = static_cast<int>(node / field.nx);
  const int di = id % 2 ? 0 : 1, dj = id % 2 ? 1 : 0;
  const double a = field.at(i, j), b = field.at(i + di, j + dj);
  // Not quite up to the nodes: points of neighbouring edges never coincide.
  const double s = std::clamp(a / (a - b), 0.02, 0.98);
  return field.origin + field.step * Vec2(i + s * di, j + s * dj);
}

std::vector<Polygon> march(const Field& field) {
  std::map<EdgeId, EdgeId> next;  // contour with the inside on its left
  auto inside = [&](int i, int j) { return field.at(i, j) <= 0; };
  for (int j = 0; j + 1 < field.ny; ++j) {
    for (int i = 0; i + 1 < field.nx; ++i) {
      const bool corner[4] = {inside(i, j), inside(i + 1, j), inside(i + 1, j + 1),
                              inside(i, j + 1)};
      const long long node = static_cast<long long>(j) * field.nx + i;
      const EdgeId edge[4] = {2 * node, 2 * (node + 1) + 1, 2 * (node + field.nx), 2 * node + 1};
      // Walking round the cell, the contour enters where inside begins and leaves where it ends:
      // from the edge where the inside ends to the one where it began. Diagonal corners stay apart.
      for (int k = 0; k < 4; ++k) {
        if (!(corner[k] && !corner[(k + 1) % 4])) continue;
        int l = k;  // back to where this run of inside corners began
        while (corner[(l + 3) % 4]) l = (l + 3) % 4;
        next[edge[k]] = edge[(l + 3) % 4];
      }
    }
  }
  std::vector<Polygon> loops;
  while (!next.empty()) {
    Polygon loop;
    EdgeId id = next.begin()->first;
    for (auto it = next.find(id); it != next.end(); it = next.find(id)) {
      loop.push_back(crossing(field, id));
      id = it->second;
      next.erase(it);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

void keep_far_points(const Polygon& loop, int a, int b, double tolerance, std::vector<char>& keep) {
  double farthest = tolerance;
  int at = -1;
  const int n = static_cast<int>(loop.size());
  for (int k = a + 1; k < b; ++k) {
    const double d = segment_distance(loop[a], loop[b % n], loop[k]);
    if (d > farthest) {
      farthest = d;
      at = k;
    }
  }
  if (at < 0) return;
  keep[at] = 1;
  keep_far_points(loop, a, at, tolerance, keep);
  keep_far_points(loop, at, b, tolerance, keep);
}

// Douglas and Peucker, from two points that are far from each other.
Polygon simplified(const Polygon& loop, double tolerance) {
  const int n = static_cast<int>(loop.size());
  int far = 0;
  for (int k = 1; k < n; ++k) {
    if ((loop[k] - loop[0]).norm() > (loop[far] - loop[0]).norm()) far = k;
  }
  std::vector<char> keep(n, 0);
  keep[0] = keep[far] = 1;
  keep_far_points(loop, 0, far, tolerance, keep);
  keep_far_points(loop, far, n, tolerance, keep);
  Polygon out;
  for (int k = 0; k < n; ++k) {
    if (keep[k]) out.push_back(loop[k]);
  }
  return out;
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return wedge(b - a, c - a) * wedge(b - a, d - a) <= 0 &&
         wedge(d - c, a - c) * wedge(d - c, b - c) <= 0;
}

bool disjoint(const std::vector<Polygon>& loops) {
  struct Segment {
    Vec2 a, b;
  };
  std::vector<Segment> all;
  for (const Polygon& loop : loops) {
    if (loop.size() < 3) return false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      all.push_back({loop[k], loop[(k + 1) % loop.size()]});
    }
  }
  std::sort(all.begin(), all.end(), [](const Segment& s, const Segment& t) {
    return std::min(s.a.x(), s.b.x()) < std::min(t.a.x(), t.b.x());
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double right = std::max(all[i].a.x(), all[i].b.x());
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (std::min(all[j].a.x(), all[j].b.x()) > right) break;
      if (all[i].a == all[j].b || all[i].b == all[j].a) continue;  // neighbours
      if (cross(all[i].a, all[i].b, all[j].a, all[j].b)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Polygon> outline_of(const std::vector<OutlineShape>& shapes, double step) {
  if (shapes.empty()) throw InvalidInput("an outline of no shapes", "pass a layout with tiles");
  const Field field = make_field(shapes, step);
  const std::vector<Polygon> exact = march(field);
  std::vector<Polygon> loops;
  for (const Polygon& loop : exact) loops.push_back(simplified(loop, 0.1 * field.step));
  if (!disjoint(loops)) loops = exact;
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  return loops;
}

}  // namespace curveups
