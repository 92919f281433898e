// SPDX-License-Identifier: LGPL-2.1-or-later
// How hands release a piece from the rings on which its membranes were glued.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

// What hands do first; the piece then comes to rest.
struct ReleasePhase {
  std::string_view name;
  bool surplus;              // whether the surplus and the anchors are still on
  std::array<bool, 2> held;  // whether the front and the back sheet are still on their rings
};

// By its name: "cut" (out of both sheets while they are on their rings), "together", "front-first",
// "back-first" (taken off the rings, then cut out). Throws InvalidInput for another.
std::vector<ReleasePhase> release_phases(const std::string& name);

}  // namespace curveups
