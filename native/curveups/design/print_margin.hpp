// SPDX-License-Identifier: LGPL-2.1-or-later
// Room that a piece needs around its tiles on the print bed.
#pragma once

#include "curveups/design/parameters.hpp"
#include "curveups/design/print_constants.hpp"

namespace curveups {

// mm from the tiles to the rim of the slab that carries them and their anchors, and a gap besides.
inline double print_margin(const Parameters& p) {
  const double anchors = p.anchors ? anchor_distance + 2 * p.anchor_radius : 0.0;
  const double support = p.support == "none" ? 0.0 : support_margin;
  return anchors + support + p.d_gap_min;
}

}  // namespace curveups
