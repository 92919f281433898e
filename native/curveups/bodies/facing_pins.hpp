// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds pins that collide between parts of a target that face one another.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

// Pairs of tiles without a common vertex of which, when actuated, a pin of one would run into the
// body or a pin of the other by more than tolerance::overlap_volume; each once, ascending. Pins
// are as large as their bounds let them be (PinBounds::lower), behind the planes that bound them:
// a layout may draw them in, and part pairs that meet beside one another; those that face one
// another need lower pins or thinner tiles.
std::vector<std::array<int, 2>> facing_pins(const DesignGeometry& geometry, double H_pin);

}  // namespace curveups
