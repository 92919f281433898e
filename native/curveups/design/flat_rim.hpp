// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether a sheet that spans a flat layout, slit along its cuts, lies in the plane.
#pragma once

#include <array>
#include <vector>

#include "curveups/design/tile_mesh.hpp"

namespace curveups {

// By vertex: 1 where it lies on a boundary or a cut, or where no tile has it. The sheet is open
// between the tiles there.
std::vector<char> open_vertices(const TileMesh& tiles);

// By vertex: the corners (3 tile + t) of the tiles around it, counter-clockwise in the plane from
// that of the lowest tile; none for open vertices.
std::vector<std::vector<int>> corners_around_inner_vertices(const TileMesh& tiles);

// The sheet covers tiles (or their pins), the strips between tiles in contact, and what strips
// enclose around uncut interior vertices. Where a target has more than the full angle around a
// vertex, as saddles do, the sides of a cut there lie on one another, however far the tiles keep
// apart: no single sheet can be slit so.
// corners: 3 M x 2, of the tiles or of their pins, counter-clockwise in the plane. Returns pairs of
// tiles whose edges of the sheet cross, each once, ascending: none where it lies in the plane.
std::vector<std::array<int, 2>> crossing_rims(const TileMesh& tiles, const Points2& corners);

}  // namespace curveups
