// SPDX-License-Identifier: LGPL-2.1-or-later
// Height of pins' tops over corners and edges of tiles, which membranes must clear at tips and
// folds: an estimate before the layout, from pins as near to corners as their bounds allow.
#pragma once

#include <vector>

#include "curveups/design/tile_mesh.hpp"

namespace curveups {

// Least height over H_pin, since membranes pass below their pins' tops. Designs of some twenty
// surfaces began to fail there.
constexpr double least_membrane_clearance = 0.3;

// Tiles of each vertex, ascending; none on the boundary or a cut, where the membrane is open.
std::vector<std::vector<int>> tiles_around_inner_vertices(const TileMesh& tiles);

// Height of the highest pin top around an inner vertex over each tile's corner there, along the
// mean normal, mm. around: the vertex's tiles. lower: their pins' least insets.
std::vector<double> corner_clearances(const TileMesh& tiles, const Array6& lower, double H_pin,
                                      Side side, int vertex, const std::vector<int>& around);

// Height of a pin's top over the edge of a contact from which its inset is `inset`, mm. dihedral:
// rad, convex positive.
double edge_clearance(double dihedral, Side side, double inset, double H_pin);

}  // namespace curveups
