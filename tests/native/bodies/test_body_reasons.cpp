// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/bodies/body_reasons.hpp"

namespace curveups {
namespace {

TEST(BodyReasons, TilesThatStandApartHaveNone) {
  EXPECT_TRUE(body_reasons({1e-3, {0, 1}}, {0, {-1, -1}}).empty());
}

// Bodies that overlap have the distance 0, as those that touch.
TEST(BodyReasons, TilesThatTouchWhenFlatAreNamed) {
  const std::vector<Finding> reasons = body_reasons({0, {3, 11}}, {0, {-1, -1}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].kind, "bodies_meet");
  EXPECT_EQ(reasons[0].tiles, (std::vector<int>{3, 11}));
}

TEST(BodyReasons, TilesThatOverlapWhenActuatedAreNamed) {
  const std::vector<Finding> reasons = body_reasons({0.5, {0, 1}}, {0.01, {0, 6}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].kind, "bodies_overlap");
  EXPECT_EQ(reasons[0].tiles, (std::vector<int>{0, 6}));
  EXPECT_EQ(std::get<double>(reasons[0].figures.at("value")), 0.01);
}

}  // namespace
}  // namespace curveups
