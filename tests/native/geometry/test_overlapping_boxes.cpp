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
  std::vector<Eigen::AlignedBox3d> boxes(n);
  for (Eigen::AlignedBox3d& box : boxes) {
    for (int d = 0; d < 3; ++d) {
      box.min()[d] = place(random);
      box.max()[d] = box.min()[d] + size(random);
    }
  }
  std::vector<std::array<int, 2>> expected;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      if (boxes[i].intersects(boxes[j])) expected.push_back({i, j});
    }
  }
  EXPECT_EQ(overlapping_boxes(boxes), expected);
}

}  // namespace
}  // namespace curveups
