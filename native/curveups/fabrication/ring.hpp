// SPDX-License-Identifier: LGPL-2.1-or-later
// Ring on which a sheet of latex stays stretched: a plate around a window, with teeth that are
// round on top, in one part or several.
#pragma once

#include <string>
#include <vector>

#include "curveups/fabrication/print_model.hpp"
#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// Part of the plate, seen from the side of the teeth, mm.
struct RingPart {
  Polygon outline;  // counter-clockwise, of any form
  Polygon window;   // counter-clockwise, inside; empty: none
  std::vector<Vec2> teeth;
  std::vector<Vec2> holes;  // as wide as teeth, through the plate
};

// Makes bodies "Ring P1" and so on, of kind "tiles", from z = 0 to `thickness`; teeth are cylinders
// with half a sphere on top. Throws InvalidInput where there is no part or one with less than three
// corners, a number is not finite or beyond 10 m, a size is not positive, or teeth are not higher
// than their radius.
PrintModel make_ring(const std::string& name, const std::vector<RingPart>& parts, double thickness,
                     double tooth_radius, double tooth_height);

}  // namespace curveups
