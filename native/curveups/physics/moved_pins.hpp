// SPDX-License-Identifier: LGPL-2.1-or-later
// A membrane that is solved already, with its pins elsewhere in space: where tiles have settled.
#pragma once

#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

// Both meshes follow, each from where it was; pin_corners, states, forces and stretches are then
// those of the new places. corners: as MembraneSolution::pin_corners. Returns whether both found
// their equilibrium.
bool move_pins(MembraneSolution& solution, const Points3& corners, const Parameters& parameters);

}  // namespace curveups
