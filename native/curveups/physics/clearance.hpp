// SPDX-License-Identifier: LGPL-2.1-or-later
// Clearance of the actuated membranes over the bodies of tiles.
#pragma once

#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

struct MembraneClearance {
  double distance = 0;  // least, mm; negative: the depth to which a membrane would cut into a body
  int tile = -1;
};

// Least distance of each patch of the membrane's domain to the bodies of the tiles it joins, H_pin
// at most. Exact distances of triangles and bodies.
std::vector<MembraneClearance> patch_clearances(const DesignGeometry& geometry,
                                                const MembraneSolution& membrane, double H_pin);

// Least clearance of all patches; H_pin where a side has no membrane. Of equal ones the last.
MembraneClearance least_clearance(const std::vector<MembraneClearance>& of_patches, double H_pin);

}  // namespace curveups
