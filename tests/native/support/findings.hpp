// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "curveups/core/finding.hpp"

namespace curveups::test {

// The first of a kind; null where there is none.
inline const Finding* find_kind(const std::vector<Finding>& found, const std::string& kind) {
  const auto it = std::find_if(found.begin(), found.end(),
                               [&](const Finding& one) { return one.kind == kind; });
  return it == found.end() ? nullptr : &*it;
}

}  // namespace curveups::test
