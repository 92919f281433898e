// SPDX-License-Identifier: LGPL-2.1-or-later
// Distances of printed tiles, overlaps of actuated tiles, and the verdict on both.
#pragma once

#include <array>
#include <vector>

#include "curveups/bodies/tile_print.hpp"
#include "curveups/core/finding.hpp"

namespace curveups {

struct PairFigure {
  double value = 0;
  std::array<int, 2> tiles{-1, -1};  // -1: there is no pair
};

// Exact least distance of two tiles in the flat layout, mm, pins and bumps included; 0 where two
// overlap, infinite with one tile.
PairFigure min_clearance_flat(const TileBodies& bodies);

// Largest volume (mm3) that two tiles share in the actuated configuration: bodies without recess
// and pins, bumps aside.
PairFigure max_overlap_actuated(const TileBodies& bodies);

// Why bodies make a design not valid: tiles that meet in the flat layout, or share more than
// tolerance::overlap_volume when actuated. flat: min_clearance_flat, actuated:
// max_overlap_actuated.
std::vector<Finding> body_reasons(const PairFigure& flat, const PairFigure& actuated);

}  // namespace curveups
