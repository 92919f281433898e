// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/bump_pattern.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace curveups {
namespace {

constexpr double least_spread = 0.3;  // height of the triangle of three bumps, mm

// Ends of the polygon's chord at height y.
std::array<Vec2, 2> chord(const Polygon& polygon, double y) {
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() - y) * (b.y() - y) > 0 || a.y() == b.y()) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return {Vec2(low, y), Vec2(high, y)};
}

// Two bumps at the ends of the longer chord, one in the middle of the other.
std::vector<Vec2> in_rows(const Polygon& region) {
  double low = 1e300, high = -1e300;
  for (const Vec2& p : region) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  if (high - low < least_spread) return {};
  auto row = chord(region, low + (high - low) * 1e-6);
  auto other = chord(region, low + (high - low) * (1 - 1e-6));
  const auto length = [](const std::array<Vec2, 2>& ends) { return ends[1].x() - ends[0].x(); };
  if (length(other) > length(row) + 1e-6) std::swap(row, other);
  const auto at = [](const std::array<Vec2, 2>& ends, double share) -> Vec2 {
    return ends[0] + share * (ends[1] - ends[0]);
  };
  return {at(row, 0), at(row, 1), at(other, 0.5)};
}

// The corners of the region that span the largest triangle.
std::vector<Vec2> largest_triangle(const Polygon& region) {
  std::vector<Vec2> best;
  double largest = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::size_t j = i + 1; j < region.size(); ++j) {
      for (std::size_t k = j + 1; k < region.size(); ++k) {
        const double area = std::abs(wedge(region[j] - region[i], region[k] - region[i]));
        if (area <= largest) continue;
        largest = area;
        best = {region[i], region[j], region[k]};
      }
    }
  }
  return best;
}

// True if three centres keep the spacing and do not lie on a line.
bool spread_out(const std::vector<Vec2>& c, double spacing) {
  if (c.empty()) return false;
  const double shortest =
      std::min({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
  const Polygon hull = convex_hull(c);
  return shortest >= spacing && hull.size() == 3 && width(hull) >= least_spread;
}

}  // namespace

std::vector<Vec2> bump_pattern(const Polygon& region, double spacing) {
  std::vector<Vec2> centres = in_rows(region);
  if (!spread_out(centres, spacing)) centres = largest_triangle(region);
  if (!spread_out(centres, spacing)) return {};
  std::sort(centres.begin(), centres.end(), [](const Vec2& a, const Vec2& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  return centres;
}

}  // namespace curveups
