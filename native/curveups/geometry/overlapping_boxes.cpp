// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Box Intersection, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/overlapping_boxes.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

namespace curveups {
namespace {

// Box of the argument as CGAL's BoxIntersectionBox_d.
struct NumberedBox {
  using NT = double;
  using ID = int;
  const Eigen::AlignedBox3d* box;
  int number;
  static int dimension() { return 3; }
  ID id() const { return number; }
  NT min_coord(int d) const { return box->min()[d]; }
  NT max_coord(int d) const { return box->max()[d]; }
};

}  // namespace

std::vector<std::array<int, 2>> overlapping_boxes(const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<NumberedBox> numbered;
  for (const Eigen::AlignedBox3d& box : boxes) {
    numbered.push_back({&box, static_cast<int>(numbered.size())});
  }
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_self_intersection_d(
      numbered.begin(), numbered.end(), [&](const NumberedBox& a, const NumberedBox& b) {
        pairs.push_back({std::min(a.number, b.number), std::max(a.number, b.number)});
      });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace curveups
