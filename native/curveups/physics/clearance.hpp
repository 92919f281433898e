// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures the clearance of the actuated membranes over the bodies of tiles.
#pragma once

#include "curveups/physics/membrane_solution.hpp"

namespace curveups {

struct MembraneClearance {
  double distance = 0;  // least, mm; negative: the depth to which a membrane would cut into a body
  int tile = -1;        // where
  int patch = -1;       // in the membrane's domain
};

// Per patch of the membrane's domain, against the faces of the tiles it joins (their front or
// truncated back faces). Exact distances of triangles and faces, H_pin at most. Deterministic.
std::vector<MembraneClearance> patch_clearances(const DesignGeometry& geometry,
                                                const MembraneSolution& membrane, double H_pin);

// The least of them; H_pin where a side has no membrane.
MembraneClearance least_clearance(const std::vector<MembraneClearance>& of_patches, double H_pin);

// Distance of two triangles that do not cross, 0 where they do.
double triangle_distance(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

}  // namespace curveups
