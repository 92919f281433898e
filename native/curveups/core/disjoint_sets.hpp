// SPDX-License-Identifier: LGPL-2.1-or-later
// Numbers in sets that grow together (union-find).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace curveups {

// Of the numbers from 0 to count - 1, each in a set of its own at first.
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
  // Makes one set of two; false where they are one already.
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
