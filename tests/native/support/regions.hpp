// SPDX-License-Identifier: LGPL-2.1-or-later
// Plane regions for tests of what is made of their loops.
#pragma once

#include <algorithm>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups::test {

struct Region {
  std::vector<Vec2> points;
  std::vector<std::vector<int>> loops;

  void add(const std::vector<Vec2>& loop, bool turned = false) {
    std::vector<int> indices;
    for (const Vec2& p : loop) {
      indices.push_back(static_cast<int>(points.size()));
      points.push_back(p);
    }
    if (turned) std::reverse(indices.begin(), indices.end());
    loops.push_back(indices);
  }
};

std::vector<Vec2> square(double x, double y, double a);

std::vector<Vec2> star(int corners, double outer, double inner);

}  // namespace curveups::test
