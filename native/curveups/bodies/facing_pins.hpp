// SPDX-License-Identifier: LGPL-2.1-or-later
// Finds pins that collide between parts of a target that face one another.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/design.hpp"

namespace curveups {

// Pairs of tiles without a common vertex whose pins, when actuated, overlap the other tile by more
// than tolerance::overlap_volume; each once, ascending. Pins are as large as their bounds allow
// (PinBounds::lower), behind the planes that bound them. A layout can part pins that meet beside
// one another; pins that face one another need lower pins or thinner tiles.
std::vector<std::array<int, 2>> facing_pins(const DesignGeometry& geometry, double H_pin);

}  // namespace curveups
