// SPDX-License-Identifier: LGPL-2.1-or-later
#include "support/regions.hpp"

#include <cmath>

namespace curveups::test {

std::vector<Vec2> square(double x, double y, double a) {
  return {{x, y}, {x + a, y}, {x + a, y + a}, {x, y + a}};
}

std::vector<Vec2> star(int corners, double outer, double inner) {
  std::vector<Vec2> points;
  for (int k = 0; k < 2 * corners; ++k) {
    const double r = k % 2 ? inner : outer, a = M_PI * k / corners;
    points.emplace_back(r * std::cos(a), r * std::sin(a));
  }
  return points;
}

}  // namespace curveups::test
