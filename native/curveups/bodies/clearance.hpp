// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures how far printed tiles are from each other, and how much actuated tiles overlap.
#pragma once

#include <array>

#include "curveups/bodies/tile_bodies.hpp"

namespace curveups {

struct PairFigure {
  double value = 0;
  std::array<int, 2> tiles{-1, -1};  // the pair it belongs to, -1 where there is no pair
};

// Least 3D distance of two tiles in the flat layout, bodies, pins and bumps included, exact; 0
// where two overlap. Infinite with one tile.
PairFigure min_clearance_flat(const TileBodies& bodies);

// Largest volume (mm3) that two tiles share in the actuated configuration: bodies without recess
// and pins, bumps aside.
PairFigure max_overlap_actuated(const TileBodies& bodies);

}  // namespace curveups
