// SPDX-License-Identifier: LGPL-2.1-or-later
// Convex polygons in the plane, counter-clockwise. Results with fewer than three corners are empty;
// nothing throws.
#pragma once

#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

using Polygon = std::vector<Vec2>;

// Convex hull of at least one point, without corners on its sides; fewer than three for a line.
Polygon convex_hull(std::vector<Vec2> points);

// Part of the polygon with normal . x <= offset.
Polygon clip(const Polygon& polygon, const Vec2& normal, double offset);

// Intersection of two convex polygons.
Polygon intersection(const Polygon& a, const Polygon& b);

// Points of the polygon at least `distance` away from all of its edges.
Polygon inset(const Polygon& polygon, double distance);

// Area of any simple polygon, positive for a counter-clockwise one.
double area(const Polygon& polygon);

// Point in polygon, for any simple polygon.
bool contains(const Polygon& polygon, const Vec2& p);

// Distance of p from the polygon, 0 inside.
double distance(const Polygon& polygon, const Vec2& p);

// Least distance of two parallel lines with the polygon between them.
double width(const Polygon& polygon);

// Distance of p from the segment from a to b.
double segment_distance(const Vec2& a, const Vec2& b, const Vec2& p);

}  // namespace curveups
