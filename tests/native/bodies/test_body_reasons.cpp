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
  const std::vector<std::string> reasons = body_reasons({0, {3, 11}}, {0, {-1, -1}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0], "solids meet in the flat layout (T00004, T00012)");
}

TEST(BodyReasons, TilesThatOverlapWhenActuatedAreNamed) {
  const std::vector<std::string> reasons = body_reasons({0.5, {0, 1}}, {0.01, {0, 6}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0], "actuated tiles overlap by 0.01 mm3 (T00001, T00007)");
}

}  // namespace
}  // namespace curveups
