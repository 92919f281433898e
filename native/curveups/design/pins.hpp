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

// Recess of each wall at a contact, mm along its normal, so that the actuated shape stays true:
// half of bump_height where bumps stand between walls; xy_compensation, the growth of a print,
// where walls meet, with dimples or nothing on them.
double wall_recess(const Parameters& parameters);

}  // namespace curveups
