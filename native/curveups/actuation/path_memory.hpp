// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a path stands as numbers, for files: what contacts remember of friction, the nodes of the
// membranes and all else without which a path that goes on ends elsewhere.
#pragma once

#include "curveups/contact/contact_world.hpp"

namespace curveups {

// Of these numbers: others are of earlier versions.
inline constexpr int memory_format = 3;

// In the order in which the source writes them. Some are infinite.
Eigen::VectorXd packed(ContactWorld::PathState state);

// The inverse, for a world of the same bodies. Throws InvalidInput where the numbers are none that
// `packed` gives for it.
ContactWorld::PathState unpacked(const Eigen::VectorXd& numbers, const ContactWorld& world);

}  // namespace curveups
