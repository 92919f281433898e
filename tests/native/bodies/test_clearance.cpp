// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/bodies/clearance.hpp"

namespace curveups {
namespace {

TEST(BodyReasons, NameTilesThatTouchWhenFlatOrOverlapWhenActuated) {
  EXPECT_TRUE(body_reasons({1e-3, {0, 1}}, {0, {-1, -1}}).empty());
  const std::vector<Finding> reasons = body_reasons({0, {3, 11}}, {0.01, {0, 6}});
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_EQ(reasons[0].kind, "bodies_meet");
  EXPECT_EQ(reasons[0].tiles, (std::vector<int>{3, 11}));
  EXPECT_EQ(reasons[1].kind, "bodies_overlap");
  EXPECT_EQ(reasons[1].tiles, (std::vector<int>{0, 6}));
  EXPECT_EQ(std::get<double>(reasons[1].figures.at("value")), 0.01);
}

}  // namespace
}  // namespace curveups
