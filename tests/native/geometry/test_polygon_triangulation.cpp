// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"
#include "support/regions.hpp"

namespace curveups {
namespace {

using test::Region;
using test::square;
using test::star;

// Counter-clockwise triangles of that area in which loop edges are used once, all others twice.
void expect_covers(const Region& region, double area, int triangles) {
  const auto found = triangulate_region(region.points, region.loops);
  EXPECT_EQ(static_cast<int>(found.size()), triangles);
  std::map<std::pair<int, int>, int> uses;
  double sum = 0;
  for (const auto& t : found) {
    const double twice =
        wedge(region.points[t[1]] - region.points[t[0]], region.points[t[2]] - region.points[t[0]]);
    EXPECT_GT(twice, 0);
    sum += 0.5 * twice;
    for (int k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  }
  EXPECT_NEAR(sum, area, 1e-12 * area);
  for (const auto& loop : region.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto edge = std::minmax(loop[k], loop[(k + 1) % loop.size()]);
      EXPECT_EQ(uses[edge], 1);
      uses.erase(edge);
    }
  }
  for (const auto& [edge, count] : uses) EXPECT_EQ(count, 2);
}

TEST(PolygonTriangulation, CoversWhatAnOddNumberOfLoopsEncloses) {
  for (bool turned : {false, true}) {
    Region region;
    region.add(square(0, 0, 10));
    expect_covers(region, 100, 2);
    region.add(square(1, 1, 3), turned);
    expect_covers(region, 91, 8);  // n + 2 holes - 2
    region.add(square(5, 5, 4), turned);
    expect_covers(region, 75, 14);
    region.add(square(6, 6, 1), turned);  // an island in a hole
    expect_covers(region, 76, 16);
  }
}

TEST(PolygonTriangulation, KeepsToRegionsThatAreNotConvex) {
  Region region;
  region.add(star(7, 5, 2));
  double area = 0;
  for (int k = 0; k < 14; ++k) area += 0.5 * wedge(region.points[k], region.points[(k + 1) % 14]);
  expect_covers(region, area, 12);
  region.add(star(5, 1.5, 0.4), true);
  double hole = 0;
  for (int k = 0; k < 10; ++k) {
    hole += 0.5 * wedge(region.points[14 + k], region.points[14 + (k + 1) % 10]);
  }
  expect_covers(region, area - hole, 24);
  Region apart;  // two outer loops
  apart.add(square(0, 0, 1));
  apart.add(square(3, 0, 2));
  expect_covers(apart, 5, 4);
}

TEST(PolygonTriangulation, RefusesLoopsThatCrossOrTouch) {
  Region bow;
  bow.add({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_THROW(triangulate_region(bow.points, bow.loops), TopologyError);
  Region crossing;
  crossing.add(square(0, 0, 2));
  crossing.add(square(1, 1, 2));
  EXPECT_THROW(triangulate_region(crossing.points, crossing.loops), TopologyError);
  Region touching;
  touching.add(square(0, 0, 4));
  touching.add({{4, 2}, {2, 3}, {2, 1}});  // a corner on an edge
  EXPECT_THROW(triangulate_region(touching.points, touching.loops), TopologyError);
  Region twice;
  twice.add({{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  EXPECT_THROW(triangulate_region(twice.points, twice.loops), TopologyError);
}

// An L in a tilted plane, whose fan from the first corner would reach outside.
TEST(PolygonTriangulation, DividesAConcavePolygonInSpaceTheWayItRuns) {
  Points3 corners(6, 3);
  corners << 2, 1, 0, 2, 2, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.5, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Points3 turned = corners * turn.transpose();
  Vec3 area = Vec3::Zero();
  const auto triangles = triangulate_polygon(turned);
  EXPECT_EQ(triangles.size(), 4u);
  double sum = 0;
  for (const auto& t : triangles) {
    const Vec3 a = turned.row(t[1]) - turned.row(t[0]), b = turned.row(t[2]) - turned.row(t[0]);
    area += 0.5 * a.cross(b);
    sum += 0.5 * a.cross(b).norm();
  }
  EXPECT_NEAR(sum, area.norm(), 1e-12);  // none reaches outside
  EXPECT_NEAR(area.dot(turn * Vec3::UnitZ()), 3, 1e-12);
}

TEST(PolygonTriangulation, GivesNothingForPolygonsThatCrossThemselvesOrHaveNoArea) {
  Points3 bow(4, 3), line(4, 3);
  bow << 0, 0, 0, 2, 2, 0, 3, 0, 0, 0, 1, 0;
  line << 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0;
  EXPECT_TRUE(triangulate_polygon(bow).empty());
  EXPECT_TRUE(triangulate_polygon(line).empty());
}

}  // namespace
}  // namespace curveups
