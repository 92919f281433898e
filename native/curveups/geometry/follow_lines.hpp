// SPDX-License-Identifier: LGPL-2.1-or-later
// Places of a tiling's border and creases on another surface.
#pragma once

#include <array>
#include <vector>

#include "curveups/geometry/line_spacing.hpp"

namespace curveups {

enum class LineObstacle { none, borders, corners, creases };

struct LineMap {
  LineObstacle obstacle = LineObstacle::none;
  std::vector<Course> courses;  // lines of the surface: borders, then creases
  int borders = 0;              // number of borders
  std::vector<int> course;      // per vertex of the tiling the line that it lies on; -1: none
  std::vector<char> knot;       // per vertex: it is a corner or an end, which stays
  Points3 place;                // per vertex on a line its place
  std::vector<std::array<int, 2>> features;  // edges of the tiling on creases
};

// Maps each border of the tiling to the nearest one of the surface, corners (turns above
// `corner_angle`, rad, and ends of creases) to corners and vertices between them by their share of
// the arc; creases likewise. guess: about where the tiling's vertices are on the surface. features:
// creases of the surface; those of the tiling are its edges that bend by more than `crease_angle`
// (rad). Reports an obstacle where borders or creases do not correspond. Throws what boundary_loops
// throws.
LineMap map_lines(const TriangleMesh& tiles, const Points3& guess, const TriangleMesh& surface,
                  const Edges& features, double crease_angle, double corner_angle);

}  // namespace curveups
