// SPDX-License-Identifier: LGPL-2.1-or-later
// Truncation planes that keep tiles apart in the actuated configuration (paper, A.2, and the cases
// it leaves out).
#pragma once

#include <array>
#include <vector>

#include "curveups/design/convex_body.hpp"
#include "curveups/design/tile_mesh.hpp"

namespace curveups {

struct TruncationPlane {
  Plane plane;  // in the tile's frame
  int other;    // the tile on the other side
  int vertex;   // the front vertex they share, -1 for tiles that share none
  int type;     // 1 to 3: A.2's two types and the third, four crossing rays; 4: no common vertex
};

struct Truncation {
  std::vector<std::vector<TruncationPlane>> of_tile;
  std::array<int, 5> pairs_of_type{};            // number of pairs settled by each type, from 1
  std::vector<std::array<int, 2>> unresolved;    // pairs that no plane separates without losing a
                                                 // contact point: an error of the target
};

// Planes for every pair of tiles that share a front vertex but no edge (interior vertices, boundary
// vertices and cut ones alike), then for the pairs without a common vertex whose bodies still
// overlap, found by spatial search. Closed form: no iteration, no tolerance but tolerance::snap.
// depth: how far below the front faces tiles must be kept apart, H_body + H_pin, so that the back
// pins are too. Throws InfeasibleDesign where one tile's cone lies inside another's (folded over).
Truncation compute_truncation(const TileMesh& tiles, double depth);

// The tile's body in its own frame with its truncation planes applied; each wall t is moved into the
// body by recess[t] (mm, along its normal) first.
ConvexBody tile_body(const TileMesh& tiles, const Truncation& truncation, int tile,
                     const std::array<double, 3>& recess = {0, 0, 0});

}  // namespace curveups
