// SPDX-License-Identifier: LGPL-2.1-or-later
// Contours at a distance from a set of plane shapes: the outline of slabs and the line on which
// anchors stand. Marching squares on a distance field, robust for any layout.
#pragma once

#include <vector>

#include "curveups/geometry/convex_polygon.hpp"

namespace curveups {

struct Disc {
  Vec2 centre;
  double radius;
};

// A convex polygon or a disc, and the distance from it at which the contour runs.
struct OutlineShape {
  Polygon polygon;  // empty: the disc
  Disc disc{Vec2::Zero(), 0};
  double offset;
};

// Loops of the boundary of the union of all shapes grown by their offsets, simple and disjoint; the
// outer ones counter-clockwise, holes clockwise, the one with the largest area first. Accurate to
// about 0.1 times `step` outwards of the exact boundary, half a step in its re-entrant corners;
// simplified by as much.
std::vector<Polygon> outline_of(const std::vector<OutlineShape>& shapes, double step);

}  // namespace curveups
