// SPDX-License-Identifier: LGPL-2.1-or-later
// Contours at a distance from a set of plane shapes: the outline of slabs and the line on which
// anchors stand.
#pragma once

#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// Convex polygon or one point, and the distance of the contour from it, mm.
struct OutlineShape {
  Polygon polygon;
  double offset;
};

// Boundary loops of the union of all shapes grown by their offsets, simple; outer loops
// counter-clockwise, holes clockwise, the largest area first. Chords lie up to `deviation` (mm)
// inside of their arcs. Holes smaller than its square are closed. Corners that stand out by less
// than 0.1 micrometres, or are as near to the next, are left out: meshes in single precision would
// cross themselves there. Throws InvalidInput without shapes.
std::vector<Polygon> outline_of(const std::vector<OutlineShape>& shapes, double deviation);

// Largest part, with its holes, of an outline (from outline_of) inside of `region` (any polygon;
// empty: the plane) and outside of the `taken` loops grown by `apart`.
std::vector<Polygon> outline_without(const std::vector<Polygon>& outline, const Polygon& region,
                                     const std::vector<Polygon>& taken, double apart,
                                     double deviation);

}  // namespace curveups
