// SPDX-License-Identifier: LGPL-2.1-or-later
// How high the tops of pins stand over what membranes must clear: corners and edges of tiles at
// tips and folds. An estimate from pins that stand as near to corners as they may; the layout has
// the last word.
#pragma once

#include <vector>

#include "curveups/design/tile_mesh.hpp"

namespace curveups {

// A membrane passes below its pins' tops: they have to stand higher than this part of H_pin. Where
// designs of some twenty surfaces began to fail.
constexpr double least_membrane_clearance = 0.3;

// By vertex, ascending; none for vertices of the boundary or of a cut, where the membrane is open.
std::vector<std::vector<int>> tiles_around_inner_vertices(const TileMesh& tiles);

// Of the tiles around an inner vertex (all that have it as a corner): by how much the highest pin
// top there stands over the tile's corner, along the mean normal, mm. lower: the least insets of at
// least these tiles' pins.
std::vector<double> corner_clearances(const TileMesh& tiles, const Array6& lower, double H_pin,
                                      Side side, int vertex, const std::vector<int>& around);

// The same for the edge of a contact and a pin whose inset there is `inset`, mm. fold: rad, convex
// positive.
double edge_clearance(double dihedral, Side side, double inset, double H_pin);

}  // namespace curveups
