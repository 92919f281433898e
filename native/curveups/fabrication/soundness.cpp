// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/soundness.hpp"

#include <algorithm>

namespace curveups {
namespace {

constexpr std::size_t most_named = 3;  // unsound solids in a sentence

}  // namespace

std::vector<Finding> solid_reasons(const std::vector<UnsoundSolid>& unsound) {
  if (unsound.empty()) return {};
  Finding found = {"unsound"};
  std::vector<Finding> named;
  for (const UnsoundSolid& solid : unsound) {
    if (solid.tile >= 0) found.tiles.push_back(solid.tile);
    if (named.size() == most_named) continue;
    named.push_back({"unsound.solid", {}, {{"body", solid.body}, {"why", solid.reason}}});
  }
  std::sort(found.tiles.begin(), found.tiles.end());
  const int more = static_cast<int>(unsound.size() - named.size());
  found.figures["solids"] = std::move(named);
  if (more > 0) {
    found.kind = "unsound.many";
    found.figures["more"] = more;
  }
  return {found};
}

}  // namespace curveups
