// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <set>

#include "curveups/bodies/bump_pattern.hpp"

namespace curveups {
namespace {

const Polygon trapezium = {{0, 0}, {4, 0}, {3.5, 2}, {0.5, 2}};

// The least distance of two points, and the width of their hull: 0 on a line.
double least_distance(const std::vector<Vec2>& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
  }
  return least;
}

TEST(BumpPattern, StandsInTheRoomInRowsApartAndNotOnALine) {
  for (int count = 3; count <= 9; ++count) {
    SCOPED_TRACE(count);
    const std::vector<Vec2> found = bump_pattern(trapezium, count, 0.3);
    ASSERT_EQ(static_cast<int>(found.size()), count);
    std::set<long> heights;
    for (const Vec2& p : found) {
      heights.insert(std::lround(1e4 * p.y()));
      for (std::size_t k = 0; k < trapezium.size(); ++k) {
        const Vec2 &a = trapezium[k], &b = trapezium[(k + 1) % trapezium.size()];
        EXPECT_GE(wedge(b - a, p - a), -1e-9);
      }
    }
    EXPECT_EQ(heights.size(), 2u);
    EXPECT_GE(least_distance(found), 0.3);
    EXPECT_GT(width(convex_hull(found)), 0.29);
  }
}

TEST(BumpPattern, TakesCornersWhereRowsAreTooNarrowAndNothingWhereThreeDoNotFit) {
  const std::vector<Vec2> three = bump_pattern(trapezium, 9, 2.0);
  ASSERT_EQ(three.size(), 3u);
  EXPECT_GE(least_distance(three), 2.0);
  EXPECT_TRUE(bump_pattern(trapezium, 3, 4.5).empty());
  EXPECT_TRUE(bump_pattern({{0, 0}, {4, 0}, {4, 0.1}, {0, 0.1}}, 3, 0.5).empty());
  EXPECT_TRUE(bump_pattern({}, 3, 0.5).empty());
}

}  // namespace
}  // namespace curveups
