// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/polygon_division.hpp"
#include "support/regions.hpp"

namespace curveups {
namespace {

using test::Region;
using test::square;
using test::star;

double area(const Region& region, const std::vector<int>& polygon) {
  double twice = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec2& o = region.points[polygon[0]];
    twice += wedge(region.points[polygon[k]] - o, region.points[polygon[k + 1]] - o);
  }
  return 0.5 * twice;
}

// Polygons of positive area, of that area in all, that visit no point twice, in which edges of
// loops are used once and all others twice, there and back.
std::vector<std::vector<int>> expect_divided(const Region& region, double whole, int most) {
  const auto polygons = divide_region(region.points, region.loops, most);
  std::map<std::pair<int, int>, int> uses;
  std::set<std::pair<int, int>> of_loops;
  for (const auto& loop : region.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      of_loops.insert(std::minmax(loop[k], loop[(k + 1) % loop.size()]));
    }
  }
  double sum = 0;
  for (const std::vector<int>& polygon : polygons) {
    EXPECT_GE(polygon.size(), 3u);
    EXPECT_LE(static_cast<int>(polygon.size()), most);
    EXPECT_EQ(std::set<int>(polygon.begin(), polygon.end()).size(), polygon.size());
    EXPECT_GT(area(region, polygon), 0);
    sum += area(region, polygon);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      ++uses[{polygon[k], polygon[(k + 1) % polygon.size()]}];
    }
  }
  EXPECT_NEAR(sum, whole, 1e-12 * whole);
  std::size_t on_loops = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);
    const bool both = uses.count({edge.second, edge.first}) > 0;
    EXPECT_NE(both, of_loops.count(std::minmax(edge.first, edge.second)) > 0);
    on_loops += !both;
  }
  EXPECT_EQ(on_loops, of_loops.size());
  return polygons;
}

TEST(PolygonDivision, LeavesWhatHasNoHolesWhole) {
  Region region;
  region.add(star(7, 10, 3));
  const double whole = 7 * 10 * 3 * std::sin(M_PI / 7);
  EXPECT_EQ(expect_divided(region, whole, 14).size(), 1u);
  EXPECT_GE(expect_divided(region, whole, 5).size(), 4u);
  EXPECT_EQ(expect_divided(region, whole, 3).size(), 12u);
}

TEST(PolygonDivision, CutsAroundAHoleTwice) {
  for (bool turned : {false, true}) {
    Region region;
    region.add(square(0, 0, 10));
    region.add(square(4, 3, 2), turned);
    EXPECT_EQ(expect_divided(region, 96, 12).size(), 2u);
  }
}

TEST(PolygonDivision, KeepsShortEdgesBetweenNeighbours) {
  // A row of squares with gaps of 1 that are nearer to one another than to the border.
  Region region;
  region.add({{0, 0}, {60, 0}, {60, 30}, {0, 30}});
  for (int i = 0; i < 5; ++i) region.add(square(10 + 8 * i, 11.5, 7), true);
  const auto polygons = expect_divided(region, 1800 - 5 * 49, 24);
  EXPECT_LE(polygons.size(), 6u);
  double longest_between = 0;
  for (const auto& polygon : polygons) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const int a = polygon[k], b = polygon[(k + 1) % polygon.size()];
      if (a < 4 || b < 4 || (a - 4) / 4 == (b - 4) / 4) continue;
      longest_between = std::max(longest_between, (region.points[a] - region.points[b]).norm());
    }
  }
  EXPECT_NEAR(longest_between, 1, 1e-12);  // never the diagonal of a gap
}

TEST(PolygonDivision, ManyHolesIslandsAndSeparateParts) {
  Region region;
  region.add(square(0, 0, 200));
  for (int j = 0; j < 19; ++j) {
    for (int i = 0; i < 19; ++i) {
      std::vector<Vec2> hole = star(3, 4, 2);
      for (Vec2& p : hole) p += Vec2(10 + 10 * i + 0.3 * j, 8 + 10 * j - 0.2 * i);
      region.add(hole, (i + j) % 2 == 0);
    }
  }
  const double hole = 3 * 4 * 2 * std::sin(M_PI / 3);
  region.add(square(300, 0, 20));  // apart, with a hole and an island in it
  region.add(square(305, 5, 10));
  region.add(square(309, 9, 2));
  const auto polygons = expect_divided(region, 40000 - 361 * hole + 400 - 100 + 4, 16);
  EXPECT_LT(polygons.size(), 361u * 2);
  EXPECT_EQ(polygons, divide_region(region.points, region.loops, 16));
}

TEST(PolygonDivision, RefusesLoopsThatTouchAndPolygonsOfTwoCorners) {
  Region region;
  region.add(square(0, 0, 10));
  EXPECT_THROW(divide_region(region.points, region.loops, 2), InvalidInput);
  region.add(square(8, 8, 4));
  EXPECT_THROW(divide_region(region.points, region.loops, 16), TopologyError);
}

}  // namespace
}  // namespace curveups
