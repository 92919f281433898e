// SPDX-License-Identifier: LGPL-2.1-or-later
// Convex polygons in the plane, counter-clockwise, in one unit of length. Nothing throws: what is
// nothing (fewer than three corners) is empty.
#pragma once

#include <vector>

#include "curveups/core/types.hpp"

namespace curveups {

using Polygon = std::vector<Vec2>;

// Of at least one point; without corners on its sides. Points on a line give fewer than three.
Polygon convex_hull(std::vector<Vec2> points);

// Keeps what has normal . x <= offset; empty where nothing is left.
Polygon clip(const Polygon& polygon, const Vec2& normal, double offset);

// What two convex polygons have in common.
Polygon intersection(const Polygon& a, const Polygon& b);

// Points of the polygon at least `distance` away from all of its edges.
Polygon inset(const Polygon& polygon, double distance);

// Of any simple polygon, positive where it runs counter-clockwise.
double area(const Polygon& polygon);

// Whether p lies inside any simple polygon.
bool contains(const Polygon& polygon, const Vec2& p);

// Distance of p from the polygon, 0 inside.
double distance(const Polygon& polygon, const Vec2& p);

// Least distance of two parallel lines that have the polygon between them.
double width(const Polygon& polygon);

// Distance of p from the segment from a to b.
double segment_distance(const Vec2& a, const Vec2& b, const Vec2& p);

}  // namespace curveups
