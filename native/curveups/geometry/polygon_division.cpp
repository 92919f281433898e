// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/polygon_division.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"

namespace curveups {
namespace {

// An edge between two triangles; the left one runs along it from a to b.
struct InnerEdge {
  int a, b, left, right;
  double height;  // of the lower of the two over it
};

double height_over(int a, int b, const std::array<int, 3>& triangle,
                   const std::vector<Vec2>& points) {
  const Vec2 &p = points[triangle[0]], &q = points[triangle[1]], &r = points[triangle[2]];
  return wedge(q - p, r - p) / (points[b] - points[a]).norm();
}

std::vector<InnerEdge> inner_edges(const std::vector<Vec2>& points,
                                   const std::vector<std::array<int, 3>>& triangles) {
  std::map<std::pair<int, int>, int> at;  // triangle of a directed edge
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      at[{triangles[i][k], triangles[i][(k + 1) % 3]}] = static_cast<int>(i);
    }
  }
  std::vector<InnerEdge> edges;
  for (const auto& [edge, left] : at) {
    const auto [a, b] = edge;
    if (a > b) continue;
    const auto right = at.find({b, a});
    if (right == at.end()) continue;
    edges.push_back({a, b, left, right->second,
                     std::min(height_over(a, b, triangles[left], points),
                              height_over(a, b, triangles[right->second], points))});
  }
  return edges;
}

// Polygons that grow by taking in their neighbours.
class Merger {
 public:
  Merger(std::size_t point_count, const std::vector<std::array<int, 3>>& triangles,
         std::size_t most_corners)
      : most_corners_(most_corners), seen_(point_count, -1), into_(triangles.size()) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      polygons_.emplace_back(triangles[i].begin(), triangles[i].end());
      into_[i] = static_cast<int>(i);
    }
  }

  // Makes one polygon of the two beside the edge, unless that would have too many corners or would
  // touch itself: where they have other points in common, it would go around what lies between.
  void remove(const InnerEdge& edge) {
    const int left = polygon_of(edge.left), right = polygon_of(edge.right);
    std::vector<int>&to = polygons_[left], &from = polygons_[right];
    if (to.size() + from.size() - 2 > most_corners_ || common_points(to, from) != 2) return;
    // to: b ... a, from: a ... b; of `from` only what lies between is new.
    std::rotate(to.begin(), std::find(to.begin(), to.end(), edge.b), to.end());
    std::rotate(from.begin(), std::find(from.begin(), from.end(), edge.a), from.end());
    to.insert(to.end(), from.begin() + 1, from.end() - 1);
    from.clear();
    into_[right] = left;
  }

  std::vector<std::vector<int>> take() {
    polygons_.erase(std::remove_if(polygons_.begin(), polygons_.end(),
                                   [](const std::vector<int>& p) { return p.empty(); }),
                    polygons_.end());
    return std::move(polygons_);
  }

 private:
  int polygon_of(int triangle) {
    while (into_[triangle] != triangle) triangle = into_[triangle] = into_[into_[triangle]];
    return triangle;
  }

  int common_points(const std::vector<int>& a, const std::vector<int>& b) {
    ++stamp_;
    for (int i : a) seen_[i] = stamp_;
    return static_cast<int>(
        std::count_if(b.begin(), b.end(), [&](int i) { return seen_[i] == stamp_; }));
  }

  std::size_t most_corners_;
  std::vector<int> seen_;  // stamp of the last polygon with a point
  int stamp_ = -1;
  std::vector<int> into_;  // the polygon that took a triangle's in
  std::vector<std::vector<int>> polygons_;
};

}  // namespace

std::vector<std::vector<int>> divide_region(const std::vector<Vec2>& points,
                                            const std::vector<std::vector<int>>& loops,
                                            int most_corners) {
  if (most_corners < 3) {
    throw InvalidInput("polygons of " + std::to_string(most_corners) + " corners",
                       "allow three or more");
  }
  const std::vector<std::array<int, 3>> triangles = triangulate_region(points, loops);
  std::vector<InnerEdge> edges = inner_edges(points, triangles);
  std::stable_sort(edges.begin(), edges.end(),
                   [](const InnerEdge& e, const InnerEdge& f) { return e.height < f.height; });
  Merger merger(points.size(), triangles, static_cast<std::size_t>(most_corners));
  for (const InnerEdge& edge : edges) merger.remove(edge);
  return merger.take();
}

}  // namespace curveups
