// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Box Intersection, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/overlapping_boxes.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace curveups {
namespace {

// Row of the arguments as CGAL's BoxIntersectionBox_d.
struct RowBox {
  using NT = double;
  using ID = int;
  const Points3 *low, *high;
  int row;
  static int dimension() { return 3; }
  ID id() const { return row; }
  NT min_coord(int d) const { return (*low)(row, d); }
  NT max_coord(int d) const { return (*high)(row, d); }
};

}  // namespace

std::vector<std::array<int, 2>> overlapping_boxes(const Points3& low, const Points3& high) {
  std::vector<RowBox> boxes;
  for (int i = 0; i < low.rows(); ++i) boxes.push_back({&low, &high, i});
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const RowBox& a, const RowBox& b) {
    pairs.push_back({std::min(a.row, b.row), std::max(a.row, b.row)});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace curveups
