// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <random>

#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

TEST(OverlappingBoxes, AreThoseOfAllPairs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-50, 50), size(0, 9);
  const int n = 200;
  Points3 low(n, 3), high(n, 3);
  for (int i = 0; i < n; ++i) {
    for (int d = 0; d < 3; ++d) {
      low(i, d) = place(random);
      high(i, d) = low(i, d) + size(random);
    }
  }
  std::vector<std::array<int, 2>> expected;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      if ((low.row(i).array() <= high.row(j).array()).all() &&
          (low.row(j).array() <= high.row(i).array()).all()) {
        expected.push_back({i, j});
      }
    }
  }
  EXPECT_EQ(overlapping_boxes(low, high), expected);
}

}  // namespace
}  // namespace curveups
