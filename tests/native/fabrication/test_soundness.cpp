// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/fabrication/soundness.hpp"

namespace curveups {
namespace {

TEST(SolidReasons, SoundSolidsThatStandApartHaveNone) {
  EXPECT_TRUE(solid_reasons({}, 1e-3, 0).empty());
}

// Bodies that overlap have the distance 0, as those that touch.
TEST(SolidReasons, BodiesThatTouchWhenFlat) {
  const std::vector<std::string> reasons = solid_reasons({}, 0, 0);
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_NE(reasons[0].find("meet in the flat layout"), std::string::npos);
}

TEST(SolidReasons, UnsoundAndOverlappingBodiesAreNamed) {
  const std::vector<std::string> reasons = solid_reasons(
      {{"T00001", "open"}, {"T00002", "open"}, {"T00003", "open"}, {"T00004", "open"}}, 0.5, 0.01);
  ASSERT_EQ(reasons.size(), 2u);
  EXPECT_NE(reasons[0].find("T00003: open and 1 more"), std::string::npos) << reasons[0];
  EXPECT_NE(reasons[1].find("0.01 mm3"), std::string::npos) << reasons[1];
}

}  // namespace
}  // namespace curveups
