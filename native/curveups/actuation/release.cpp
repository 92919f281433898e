// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/actuation/release.hpp"

#include "curveups/core/errors.hpp"

namespace curveups {

std::vector<ReleasePhase> release_phases(const std::string& name) {
  const ReleasePhase cut{"cut out", false, {false, false}}, both{"both off", true, {false, false}},
      front{"front off", true, {false, true}}, back{"back off", true, {true, false}};
  if (name == "cut") return {cut};
  if (name == "together") return {both, cut};
  if (name == "front-first") return {front, both, cut};
  if (name == "back-first") return {back, both, cut};
  throw InvalidInput("there is no release '" + name + "'",
                     "give cut, together, front-first or back-first");
}

}  // namespace curveups
