// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/bodies/bump_pattern.hpp"

namespace curveups {
namespace {

const Polygon trapezium = {{0, 0}, {4, 0}, {3.5, 2}, {0.5, 2}};

double least_distance(const std::vector<Vec2>& points) {
  double least = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
  }
  return least;
}

TEST(BumpPattern, StandsInTheRoomInRowsApartAndNotOnALine) {
  const std::vector<Vec2> centres = bump_pattern(trapezium, 0.3);
  ASSERT_EQ(centres.size(), 3u);
  for (const Vec2& p : centres) {
    for (std::size_t k = 0; k < trapezium.size(); ++k) {
      const Vec2 &a = trapezium[k], &b = trapezium[(k + 1) % trapezium.size()];
      EXPECT_GE(wedge(b - a, p - a), -1e-9);
    }
  }
  EXPECT_GE(least_distance(centres), 0.3);
  EXPECT_NEAR(area(convex_hull(centres)), 4, 1e-4);  // two at the longer side, one at the other
}

TEST(BumpPattern, TakesCornersWhereRowsAreTooNarrowAndNothingWhereThreeDoNotFit) {
  const Polygon narrow = {{0, 0}, {4, 0}, {4, 2}, {3.9, 2}};
  EXPECT_EQ(bump_pattern(narrow, 2.0).size(), 3u);
  EXPECT_GE(least_distance(bump_pattern(narrow, 2.0)), 2.0);
  EXPECT_TRUE(bump_pattern(trapezium, 4.5).empty());
  EXPECT_TRUE(bump_pattern({{0, 0}, {4, 0}, {4, 0.1}, {0, 0.1}}, 0.5).empty());
  EXPECT_TRUE(bump_pattern({}, 0.5).empty());
}

}  // namespace
}  // namespace curveups
