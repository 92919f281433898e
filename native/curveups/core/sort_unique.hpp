// SPDX-License-Identifier: LGPL-2.1-or-later
// Sorted lists without repetitions.
#pragma once

#include <algorithm>

namespace curveups {

// Sorts a list and removes repeated entries.
template <class List>
void sort_unique(List& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace curveups
