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

// What one side of a tile leaves for its pin.
struct PinRegion {
  std::array<double, 3> lower, upper;  // of the insets, mm
  std::vector<PinKeepout> keepouts;    // those that can bind within the bounds
  double scale;  // of the largest pin against the front triangle; negative where none is possible
  double area;   // of the largest pin, mm2; 0 where none is possible
};

// Bounds as in compute_pin_bounds, with the given p_min, and insets of at least `least` (mm) for
// holes of joints, which it does not look for by itself.
PinRegion pin_region(const TileMesh& tiles, const Truncation& truncation,
                     const Parameters& parameters, int tile, Side side, double p_min,
                     const std::array<double, 3>& least = {0, 0, 0});

// A pin side whose area is below A_pin_min.
struct SmallPin {
  int tile;
  Side side;
  double area;  // mm2: the most its bounds allow, or what it has in a finished design
};

// A bound of an inset that gave way where nothing would have been feasible.
struct RelaxedBound {
  std::string what;  // the parameter: "p_min", or "p_max" for what bounds an inset from above
  int tile;
  Side side;
  int edge;
  double from, to;  // mm
};

struct PinBounds {
  Array6 lower, upper;  // mm
  std::vector<PinKeepout> keepouts;
  PerSide least_area;                 // mm2
  std::vector<SmallPin> small;        // sides with least_area below A_pin_min
  std::vector<RelaxedBound> relaxed;  // by tile, side and edge
};

// Bounds of every inset: p_min and p_max (p_min counted from the recessed edge where walls are
// recessed), the limits of sharp folds at pin level (on the concave side facing pins would meet, on
// the convex side the membrane would cut into the tile's edge), and corners clear of every
// truncation plane. A side whose bounds allow less than A_pin_min is listed and gets what is
// possible as its least_area; where not even A_pin_floor is possible its p_min is lowered as far as
// it must be, to p_floor at most. Where lower and upper contradict one another lower wins: pins
// that meet are worse than a membrane that touches an edge. What was relaxed is listed. With
// joint=holes insets at joints leave room for their holes (joint_inset), as far as A_pin_floor lets
// them.
PinBounds compute_pin_bounds(const TileMesh& tiles, const Truncation& truncation,
                             const Parameters& parameters);

}  // namespace curveups
