// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks that a sheet which spans a flat layout, slit along its cuts, lies in the plane.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/tile_mesh.hpp"

namespace curveups {

// Per vertex: 1 on a boundary or a cut, or without tiles. The sheet is open between the tiles
// there.
std::vector<char> open_vertices(const TileMesh& tiles);

// Per vertex: corners (3 tile + t) of the tiles around it, counter-clockwise in the plane from that
// of the lowest tile; none for open vertices.
std::vector<std::vector<int>> corners_around_inner_vertices(const TileMesh& tiles);

// Pairs of tiles at which edges of the sheet cross, each once, ascending: none where it lies in the
// plane. The sheet covers tiles (or their pins), the strips between tiles in contact, and the
// polygons that strips enclose around uncut interior vertices. Where a target has more than the
// full angle around a vertex, as saddles do, the sides of a cut there overlap, however far the
// tiles keep apart: no single sheet can be slit so. corners: 3 M x 2, of the tiles or of their
// pins, counter-clockwise in the plane.
std::vector<std::array<int, 2>> crossing_rims(const TileMesh& tiles, const Points2& corners);

}  // namespace curveups
