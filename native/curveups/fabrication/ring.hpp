// SPDX-License-Identifier: LGPL-2.1-or-later
// A ring on which a sheet of latex stays stretched: a plate around a window, with teeth that are
// round on top; in one part or several.
#pragma once

#include <string>
#include <vector>

#include "curveups/fabrication/print_model.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// A part of the plate, seen from the side of the teeth; lengths in mm.
struct RingPart {
  Polygon outline;  // counter-clockwise, of any form
  Polygon window;   // counter-clockwise, inside; empty: none
  std::vector<Vec2> teeth;
  std::vector<Vec2> holes;  // as wide as teeth, through the plate
};

// The parts, "Ring P1" and so on, lie from z = 0 to `thickness`; teeth are cylinders with half a
// sphere on top. Bodies of kind "tiles". Throws InvalidInput where there is no part or one with
// less than three corners, where a number is not finite or beyond 10 m, sizes are not positive, or
// teeth are not higher than their radius.
PrintModel make_ring(const std::string& name, const std::vector<RingPart>& parts, double thickness,
                     double tooth_radius, double tooth_height);

}  // namespace curveups
