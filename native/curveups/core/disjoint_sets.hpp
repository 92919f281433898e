// SPDX-License-Identifier: LGPL-2.1-or-later
// Union-find.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace curveups {

// Sets of the numbers from 0 to count - 1, at first one each.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  // The lowest number of i's set.
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // Joins two sets; returns false if they are one already.
  bool unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace curveups
