// SPDX-License-Identifier: LGPL-2.1-or-later
// Pins that have to grow: upper bounds of their insets below where these are.
#pragma once

#include <vector>

#include "curveups/refinement/tracked_forces.hpp"

namespace curveups {

// Where a membrane cuts into a body or all but touches it the pins around draw out: nearer to their
// edges they hold it up better. Caps the insets of the tiles touched, and of those next to them,
// below where they are. Returns whether there is any that can give way.
bool cap_insets(const std::vector<Touch>& touches, const Iterate& place, Array6& caps);

}  // namespace curveups
