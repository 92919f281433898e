// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of a layout that a test made, on a mesh that can follow other layouts.
#pragma once

#include <utility>

#include "curveups/physics/design_forces.hpp"

namespace curveups::test {

// geometry must outlive what is returned.
inline DesignForces solve_forces(const DesignGeometry& geometry, const Parameters& parameters,
                                 const FlatPoses& poses, const Array6& q) {
  auto [front, back] = solve_membranes(geometry, poses, q, parameters, {});
  return DesignForces(geometry, parameters, {std::move(front.coarse), std::move(back.coarse)},
                      poses, q);
}

}  // namespace curveups::test
