// SPDX-License-Identifier: LGPL-2.1-or-later
// Conservative test for bodies that pass through one another in a step, which springs at their
// present contact points would miss.
#pragma once

#include "curveups/contact/rigid_body.hpp"

namespace curveups {

// True where, from one set of poses to the next, two bodies that come near move against one another
// by more than half the thickness of the thinner one. A body that moves by less is inside of the
// other at the end, where a search finds it. Bodies move along screws.
bool could_pass(const std::vector<RigidBody>& bodies, const Poses& from, const Poses& to);

}  // namespace curveups
