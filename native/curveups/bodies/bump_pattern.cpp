// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bodies/bump_pattern.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace curveups {
namespace {

constexpr int rows = 2;
constexpr double least_spread = 0.3;  // height of the triangle of three bumps, mm

// The interval of the polygon at height v.
std::optional<std::array<double, 2>> chord(const Polygon& polygon, double v) {
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y() - v) * (b.y() - v) > 0) continue;
    for (double u :
         {a.y() == b.y() ? a.x() : a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x()),
          a.y() == b.y() ? b.x() : a.x() + (v - a.y()) / (b.y() - a.y()) * (b.x() - a.x())}) {
      low = std::min(low, u);
      high = std::max(high, u);
    }
  }
  if (low > high) return std::nullopt;
  return std::array<double, 2>{low, high};
}

bool far_apart(const std::vector<Vec2>& centres, double spacing) {
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((centres[i] - centres[j]).norm() < spacing) return false;
    }
  }
  return true;
}

// Two rows at the sides of the region, the longer one with one bump more where they differ.
std::vector<Vec2> in_rows(const Polygon& region, int count) {
  double low = 1e300, high = -1e300;
  for (const Vec2& p : region) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  }
  if (high - low < least_spread) return {};
  std::vector<std::array<double, 2>> chords;  // -length, v
  for (int row = 0; row < rows; ++row) {
    const double v = low + (high - low) * (row == 0 ? 1e-6 : 1 - 1e-6);
    const auto c = chord(region, v);
    if (!c) return {};
    chords.push_back({(*c)[0] - (*c)[1], v});
  }
  std::stable_sort(chords.begin(), chords.end(), [](const auto& a, const auto& b) {
    return a[0] < b[0] - 1e-6;  // rows of like length keep their order
  });
  std::vector<Vec2> centres;
  for (int row = 0; row < rows; ++row) {
    const int bumps = count / rows + (row < count % rows ? 1 : 0);
    const auto c = *chord(region, chords[row][1]);
    for (int k = 0; k < bumps; ++k) {
      const double s = bumps == 1 ? 0.5 : static_cast<double>(k) / (bumps - 1);
      centres.emplace_back(c[0] + s * (c[1] - c[0]), chords[row][1]);
    }
  }
  return centres;
}

bool spread_out(const std::vector<Vec2>& centres) {
  return !centres.empty() && width(convex_hull(centres)) >= least_spread &&
         convex_hull(centres).size() >= 3;
}

// The corners of the region that span the largest triangle.
std::vector<Vec2> largest_triangle(const Polygon& region) {
  std::vector<Vec2> best;
  double largest = 0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::size_t j = i + 1; j < region.size(); ++j) {
      for (std::size_t k = j + 1; k < region.size(); ++k) {
        const double a = std::abs(wedge(region[j] - region[i], region[k] - region[i]));
        if (a <= largest) continue;
        largest = a;
        best = {region[i], region[j], region[k]};
      }
    }
  }
  return best;
}

}  // namespace

std::vector<Vec2> bump_pattern(const Polygon& region, int count, double spacing) {
  auto good = [&](const std::vector<Vec2>& centres) {
    return spread_out(centres) && far_apart(centres, spacing);
  };
  std::vector<Vec2> found = in_rows(region, count);
  if (!good(found)) found = largest_triangle(region);
  if (!good(found)) return {};
  std::sort(found.begin(), found.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  return found;
}

}  // namespace curveups
