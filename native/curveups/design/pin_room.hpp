// SPDX-License-Identifier: LGPL-2.1-or-later
// What one side of a tile leaves for its pin.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/pins.hpp"

namespace curveups {

struct PinRoom {
  std::array<double, 3> lower, upper;  // of the insets, mm
  std::vector<PinKeepout> keepouts;    // those that can bind within the bounds
  double scale;  // of the largest pin against the front triangle; negative where none is possible
  double area;   // of the largest pin, mm2; 0 where none is possible
};

// Bounds as in compute_pin_bounds, with the given p_min.
PinRoom pin_room(const TileMesh& tiles, const Truncation& truncation, const Parameters& parameters,
                 int tile, Side side, double p_min);

}  // namespace curveups
