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
  // Planes above the front faces: they cut no body and only bound front pins.
  std::vector<std::vector<TruncationPlane>> front_pins;
  std::array<int, 5> pairs_of_type{};          // pairs separated by each type, from 1
  std::vector<std::array<int, 2>> unresolved;  // pairs that no plane separates without losing a
                                               // contact point: an error of the target
  std::vector<std::array<int, 2>> shortened;   // pairs without a common vertex whose separation
                                               // shortened interfaces of one of them
};

// Planes for every pair of tiles that share a front vertex but no edge (interior vertices, boundary
// vertices and cut ones alike). Around a common vertex D a tile is the cone of its two walls and
// its front face; two cones overlap in a cone whose edges are rays in which a wall of one crosses a
// wall of the other, towards the paper's points A and B. Any plane through D separates the two
// tiles at every depth, pins included; the one through those rays takes nothing else away. Where
// four rays cross (a type that A.2 denies), the diagonal plane that separates the tiles' centroids
// does. Closed form, linear in the number of tiles. Tiles that are folded over one another at a
// vertex are listed as unresolved.
Truncation truncate_at_vertices(const TileMesh& tiles);

// Add the planes at these vertices alone.
void truncate_at_vertices(const TileMesh& tiles, const std::vector<int>& vertices,
                          Truncation& truncation);

// The tile's body in its own frame with its truncation planes applied; each wall t is moved into
// the body by recess[t] (mm, along its normal) first.
ConvexBody tile_body(const TileMesh& tiles, const Truncation& truncation, int tile,
                     const std::array<double, 3>& recess = {0, 0, 0});

}  // namespace curveups
