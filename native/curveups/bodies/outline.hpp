// SPDX-License-Identifier: LGPL-2.1-or-later
// Contours at a distance from a set of plane shapes: the outline of slabs and the line on which
// anchors stand.
#pragma once

#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

// A convex polygon or one point, and the distance (mm) from it at which the contour runs.
struct OutlineShape {
  Polygon polygon;
  double offset;
};

// Loops of the boundary of the union of all shapes grown by their offsets, simple; the outer ones
// counter-clockwise, holes clockwise, the one with the largest area first. Arcs are chords that lie
// up to `deviation` (mm) inside of them; holes smaller than its square are closed, and corners that
// stand out by less than 0.1 micrometres, or are as near to the next, are left out: meshes in
// single precision would cross themselves there. Throws InvalidInput without shapes.
std::vector<Polygon> outline_of(const std::vector<OutlineShape>& shapes, double deviation);

// What is left of an outline (as outline_of gives it) inside of `region` (any; empty: all) and
// outside of the `taken` loops grown by `apart`: its largest part, and the holes in that.
std::vector<Polygon> outline_without(const std::vector<Polygon>& outline, const Polygon& region,
                                     const std::vector<Polygon>& taken, double apart,
                                     double deviation);

}  // namespace curveups
