// SPDX-License-Identifier: LGPL-2.1-or-later
// The feasible region of the pins of a tile: bounds of their insets.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "curveups/design/pins.hpp"

namespace curveups {

// a_prev q[t-1] + a_here q[t] >= bound: pin corner t of this side stays clear of a truncation
// plane.
struct PinKeepout {
  int tile;
  Side side;
  int corner;
  double a_prev, a_here, bound;
};

// Feasible region of the pin on one side of a tile.
struct PinRegion {
  std::array<double, 3> lower, upper;  // bounds of the insets, mm
  std::vector<PinKeepout> keepouts;    // those that can bind within the bounds
  double scale;  // lengths of the largest pin over the front triangle's; negative: there is none
  double area;   // mm2 of the largest pin; 0: there is none
};

// Region as in compute_pin_bounds with the given p_min. least: insets for holes of joints, mm.
PinRegion pin_region(const TileMesh& tiles, const Truncation& truncation,
                     const Parameters& parameters, int tile, Side side, double p_min,
                     const std::array<double, 3>& least = {0, 0, 0});

// A pin side whose area is below A_pin_min.
struct SmallPin {
  int tile;
  Side side;
  double area;  // mm2: the largest within its bounds, or that of a finished design
};

// A bound of an inset that was relaxed because nothing was feasible.
struct RelaxedBound {
  std::string what;  // the parameter: "p_min", or "p_max" for an upper bound
  int tile;
  Side side;
  int edge;
  double from, to;  // mm
};

struct PinBounds {
  Array6 lower, upper;  // mm
  std::vector<PinKeepout> keepouts;
  PerSide area, least_area;           // mm2: the largest within the bounds; the required
  std::vector<SmallPin> small;        // sides with least_area below A_pin_min
  std::vector<RelaxedBound> relaxed;  // by tile, side and edge
};

// Bounds of every inset: p_min and p_max (p_min counts from the recessed edge), the limits of sharp
// folds at pin level (on the concave side facing pins would meet, on the convex side the membrane
// would cut into the tile's edge), and corners clear of every truncation plane. With joint=holes
// insets at joints leave room for the holes (joint_inset), within A_pin_floor.
// A side whose bounds allow less than A_pin_min is listed in `small`, with the possible area as its
// least_area. Below A_pin_floor its p_min is lowered, to p_floor at most. A lower bound above an
// upper one wins: pins that meet are worse than a membrane that touches an edge.
PinBounds compute_pin_bounds(const TileMesh& tiles, const Truncation& truncation,
                             const Parameters& parameters);

}  // namespace curveups
