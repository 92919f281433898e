// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "curveups/fabrication/soundness.hpp"

namespace curveups {
namespace {

TEST(SolidReasons, SoundSolidsHaveNone) { EXPECT_TRUE(solid_reasons({}).empty()); }

TEST(SolidReasons, UnsoundBodiesAreNamed) {
  const std::vector<std::string> reasons = solid_reasons(
      {{"T00001", "open"}, {"T00002", "open"}, {"T00003", "open"}, {"T00004", "open"}});
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_NE(reasons[0].find("T00003: open and 1 more"), std::string::npos) << reasons[0];
}

}  // namespace
}  // namespace curveups
