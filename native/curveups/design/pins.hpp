// SPDX-License-Identifier: LGPL-2.1-or-later
// Pins: right prisms on both faces of a tile, given by six insets (paper, section 4 and Eq. 6).
#pragma once

#include <array>
#include <vector>

#include "curveups/design/parameters.hpp"
#include "curveups/design/truncation.hpp"

namespace curveups {

// Insets q are M x 6: the three front ones, then the three back ones, inset t from the face's edge
// t.
inline int inset_index(Side side, int t) { return (side == Side::front ? 0 : 3) + t; }

// Corners of the pin's outline in the tile's frame, counter-clockwise seen from the front.
std::array<Vec2, 3> pin_corners(const TileMesh& tiles, int tile, Side side, const double* q);

// Area of the pin's outline, mm2, negative where the insets turn it over.
double pin_area(const TileMesh& tiles, int tile, Side side, const double* q);

// a_prev q[t-1] + a_here q[t] >= bound: pin corner t of this side stays clear of a truncation
// plane.
struct PinKeepout {
  int tile;
  Side side;
  int corner;
  double a_prev, a_here, bound;
};

// A pin side whose area is below A_pin_min.
struct SmallPin {
  int tile;
  Side side;
  double area;  // mm2: the most its bounds allow, or what it has in a finished design
};

struct PinBounds {
  Array6 lower, upper;  // mm
  std::vector<PinKeepout> keepouts;
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> least_area;  // per tile and side, mm2
  std::vector<SmallPin> small;  // sides with least_area below A_pin_min
};

// Bounds of every inset: p_min and p_max (p_min counted from the recessed edge where walls are
// recessed), the limits of sharp folds at pin level (on the concave side facing pins would meet, on
// the convex side the membrane would cut into the tile's edge), and corners clear of every
// truncation plane. A side whose bounds allow less than A_pin_min is listed and gets what is
// possible as its least_area; where not even A_pin_floor is possible its p_min is lowered as far as
// it must be (to a tenth at most). Where lower and upper contradict one another lower wins: pins
// that meet are worse than a membrane that touches an edge.
PinBounds compute_pin_bounds(const TileMesh& tiles, const Truncation& truncation,
                             const Parameters& parameters);

// How far each wall is recessed (mm, along its normal) so that bumps keep the actuated shape true:
// half of bump_height at contacts, 0 elsewhere and where bumps or recessing are off.
double wall_recess(const Parameters& parameters);

}  // namespace curveups
