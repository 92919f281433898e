// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/soundness.hpp"

#include <algorithm>

namespace curveups {
namespace {

constexpr std::size_t most_named = 3;  // unsound solids in a message

}  // namespace

std::vector<std::string> solid_reasons(const std::vector<UnsoundSolid>& unsound) {
  std::vector<std::string> reasons;
  if (!unsound.empty()) {
    std::string text = "solids are not sound: ";
    for (std::size_t k = 0; k < std::min(most_named, unsound.size()); ++k) {
      text += (k > 0 ? "; " : "") + unsound[k].body + ": " + unsound[k].reason;
    }
    if (unsound.size() > most_named) {
      text += " and " + std::to_string(unsound.size() - most_named) + " more";
    }
    reasons.push_back(text);
  }
  return reasons;
}

}  // namespace curveups
