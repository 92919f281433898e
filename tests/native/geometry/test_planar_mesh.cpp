// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/planar_mesh.hpp"

namespace curveups {
namespace {

std::vector<Vec2> subdivide(const std::vector<Vec2>& corners, int parts) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    for (int k = 0; k < parts; ++k) out.push_back(a + (b - a) * k / parts);
  }
  return out;
}

const std::vector<Vec2> square = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};
const std::vector<Vec2> dart = {{0, 0}, {4, -1}, {1.5, 0.8}, {1, 4}};

double area(const PlanarMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const double part =
        wedge(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    EXPECT_GT(part, 0);
    sum += 0.5 * part;
  }
  return sum;
}

TEST(PlanarMesh, FillsThePolygonAndKeepsItsBoundary) {
  for (const auto& [corners, expected] : {std::pair(square, 9.0), std::pair(dart, 4.95)}) {
    const std::vector<Vec2> boundary = subdivide(corners, 5);
    const PlanarMesh mesh = mesh_polygon(boundary, [](const Vec2&) { return 0.8; });
    EXPECT_NEAR(area(mesh), expected, 1e-12);
    for (std::size_t i = 0; i < boundary.size(); ++i) EXPECT_EQ(mesh.points[i], boundary[i]);
    // Edges of one triangle only are the boundary's, and nothing else is.
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles) {
      for (int e = 0; e < 3; ++e) ++edges[std::minmax(t[e], t[(e + 1) % 3])];
    }
    int outer = 0;
    for (const auto& [edge, count] : edges) {
      if (count > 1) continue;
      ++outer;
      const int n = static_cast<int>(boundary.size()), step = edge.second - edge.first;
      EXPECT_TRUE(edge.second < n && (step == 1 || step == n - 1));
    }
    EXPECT_EQ(outer, static_cast<int>(boundary.size()));
  }
}

TEST(PlanarMesh, KeepsSizeAndAngles) {
  auto size = [](const Vec2& p) { return 0.32 + 0.15 * p.norm(); };
  const PlanarMesh mesh = mesh_polygon(subdivide(square, 15), size);
  for (const auto& t : mesh.triangles) {
    double longest = 0, least_angle = 4;
    Vec2 middle = Vec2::Zero();
    for (int e = 0; e < 3; ++e) {
      const Vec2 &a = mesh.points[t[e]], &b = mesh.points[t[(e + 1) % 3]],
                 &c = mesh.points[t[(e + 2) % 3]];
      longest = std::max(longest, (b - a).norm());
      least_angle = std::min(least_angle, std::atan2(wedge(b - a, c - a), (b - a).dot(c - a)));
      middle += a / 3;
    }
    EXPECT_LE(longest, size(middle));
    EXPECT_GT(least_angle, 20 * M_PI / 180);
  }
}

TEST(PlanarMesh, EndsOnSharpCornersAndUnevenBoundaries) {
  const std::vector<Vec2> needle = {{0, 0}, {10, 0}, {10, 0.3}};
  EXPECT_NEAR(area(mesh_polygon(needle, [](const Vec2&) { return 0.5; })), 1.5, 1e-12);
  const std::vector<Vec2> uneven = {{0, 0}, {0.01, 0}, {0.02, 0}, {5, 0}, {5, 5}, {0, 5}};
  EXPECT_NEAR(area(mesh_polygon(uneven, [](const Vec2&) { return 1.0; })), 25, 1e-12);
}

TEST(PlanarMesh, IsTheSameEveryTime) {
  auto size = [](const Vec2&) { return 0.4; };
  const PlanarMesh a = mesh_polygon(subdivide(square, 10), size),
                   b = mesh_polygon(subdivide(square, 10), size);
  EXPECT_EQ(a.triangles, b.triangles);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i], b.points[i]);
}

TEST(PlanarMesh, RefusesWhatIsNoSimplePolygon) {
  auto size = [](const Vec2&) { return 1.0; };
  const std::vector<std::vector<Vec2>> bad = {
      {{0, 0}, {1, 1}, {1, 0}, {0, 1}},          // crosses itself
      {{0, 0}, {0, 1}, {1, 0}},                  // clockwise
      {{0, 0}, {2, 0}, {1, 0}},                  // no area
      {{0, 0}, {1, 0}},                          // two points
      {{0, 0}, {0, 0}, {1, 0}, {0, 1}},          // a point twice
      {{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}},  // touches itself
      {{0, 0}, {NAN, 0}, {1, 1}}};
  for (const auto& boundary : bad) EXPECT_THROW(mesh_polygon(boundary, size), InvalidInput);
}

}  // namespace
}  // namespace curveups
