// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether bodies could pass through one another in a step that springs at their present contact
// points do not see: a conservative bound, by how far they move beside one another.
#pragma once

#include "curveups/contact/rigid_body.hpp"

namespace curveups {

// Whether, from one set of poses to the next, two bodies move beside one another by more than half
// the thickness of the thinner one. What moves by less can't get through without being inside at
// the end, where a search finds it. Bodies move along screws.
bool could_pass(const std::vector<RigidBody>& bodies, const Poses& from, const Poses& to);

}  // namespace curveups
