// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/fabrication/soundness.hpp"

namespace curveups {
namespace {

TEST(SolidReasons, SoundSolidsHaveNone) { EXPECT_TRUE(solid_reasons({}).empty()); }

TEST(SolidReasons, UnsoundBodiesAreNamed) {
  const std::vector<Finding> reasons = solid_reasons({{"T00001", "open", 0},
                                                      {"T00002", "open", 1},
                                                      {"T00004", "open", 3},
                                                      {"Support P1", "open"}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].kind, "unsound.many");
  EXPECT_EQ(reasons[0].tiles, (std::vector<int>{0, 1, 3}));
  const auto named = std::get<std::vector<Finding>>(reasons[0].figures.at("solids"));
  ASSERT_EQ(named.size(), 3u);
  EXPECT_EQ(std::get<std::string>(named[2].figures.at("body")), "T00004");
  EXPECT_EQ(std::get<int>(reasons[0].figures.at("more")), 1);
}

}  // namespace
}  // namespace curveups
