// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/spatial_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace curveups {

std::vector<std::array<int, 2>> overlapping_boxes(const Points3& low, const Points3& high) {
  const int count = static_cast<int>(low.rows());
  std::vector<std::array<int, 2>> pairs;
  if (count < 2) return pairs;
  // Cells as wide as the widest box: partners lie in a box's own cell or a neighbouring one. The
  // cells' number is bounded so that a few huge boxes or far apart ones don't exhaust memory.
  const Eigen::RowVector3d origin = low.colwise().minCoeff();
  const Eigen::RowVector3d extent = high.colwise().maxCoeff() - origin;
  double width = std::max((high - low).maxCoeff(), extent.maxCoeff() / 250);
  if (!(width > 0)) width = 1;
  Eigen::Array<int, 1, 3> cells;
  for (int d = 0; d < 3; ++d) cells(d) = 1 + static_cast<int>(extent(d) / width);
  auto cell = [&](int i, int d) {
    return std::min(cells(d) - 1, static_cast<int>((low(i, d) - origin(d)) / width));
  };
  auto number = [&](int x, int y, int z) { return (z * cells(1) + y) * cells(0) + x; };
  std::vector<int> first(static_cast<std::size_t>(cells.prod()) + 1, 0), of(count);
  for (int i = 0; i < count; ++i) {
    of[i] = number(cell(i, 0), cell(i, 1), cell(i, 2));
    ++first[of[i] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> members(count), cursor(first.begin(), first.end() - 1);
  for (int i = 0; i < count; ++i) members[cursor[of[i]]++] = i;
  for (int i = 0; i < count; ++i) {
    const std::size_t start = pairs.size();
    const int x = cell(i, 0), y = cell(i, 1), z = cell(i, 2);
    for (int c = std::max(0, z - 1); c <= std::min(cells(2) - 1, z + 1); ++c) {
      for (int b = std::max(0, y - 1); b <= std::min(cells(1) - 1, y + 1); ++b) {
        for (int a = std::max(0, x - 1); a <= std::min(cells(0) - 1, x + 1); ++a) {
          const int n = number(a, b, c);
          for (int m = first[n]; m < first[n + 1]; ++m) {
            const int j = members[m];
            if (j <= i) continue;
            if ((low.row(i).array() > high.row(j).array()).any()) continue;
            if ((low.row(j).array() > high.row(i).array()).any()) continue;
            pairs.push_back({i, j});
          }
        }
      }
    }
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(start), pairs.end());
  }
  return pairs;
}

}  // namespace curveups
