// SPDX-License-Identifier: LGPL-2.1-or-later
// Target surfaces that come with the program, each a formula over a region of the plane.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct LiftedRegion;

struct BuiltinTarget {
  std::string name, meaning;
  LiftedRegion (*region)();
};

const std::vector<BuiltinTarget>& builtin_targets();

// A fine triangulation (mm, fronts outward) whose vertices lie on the surface and whose faces stay
// within about `tolerance` of it: 0.0035 mm is 0.0005 of the default tile edge. Throws InvalidInput
// for an unknown name and a tolerance outside 1e-4 to 1 mm.
TriangleMesh builtin_target(const std::string& name, double tolerance = 0.0035);

}  // namespace curveups
