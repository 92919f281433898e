// SPDX-License-Identifier: LGPL-2.1-or-later
// Tiles as they are printed: truncated without edges that no reader of a file could want.
#pragma once

#include <array>

#include "curveups/design/tile_mesh.hpp"
#include "curveups/design/truncation.hpp"

namespace curveups {

// Truncation planes keep this far away from a tile's corners, or pass through them: shorter edges
// would be a hundredth of what any printer resolves, and other programs may take their ends for one
// corner.
inline constexpr double least_cut = 1e-3;  // mm

// As tile_body, but each plane that passes a corner by less than least_cut is moved into the tile,
// by less than twice that: to the corner where that is kept, else to a deeper cut. Corners that lie
// on the plane stay there: it turns about them.
ConvexBody printed_body(const TileMesh& tiles, const Truncation& truncation, int tile,
                        const std::array<double, 3>& recess = {0, 0, 0});

}  // namespace curveups
