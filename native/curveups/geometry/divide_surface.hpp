// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface in several pieces, each of which can be laid flat by itself.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Least mean number of faces of a piece.
inline constexpr int least_faces_of_piece = 12;

struct SurfaceDivision {
  std::vector<int> piece;  // per face, from 0 in the order of the lowest faces
  Edges borders;           // edges between pieces besides the given cuts
  Edges slits;             // cuts inside of pieces, which then lie flat
};

// Divides a surface that is cut along the edges with cut[edge] != 0 (one entry per topology.edges,
// or empty) into `count` pieces of about the same area with short borders; pieces under the given
// cuts count. All edges are vertex pairs, the lower first, ascending. Slits: shortest paths join
// several loops of new borders to one, as a ring lies flat with less stretch than a tube;
// opening_cuts does the rest (handles, closed parts). Holes of the surface may stay. Deterministic.
// Throws InvalidInput for a count below one or of less than least_faces_of_piece faces each, and
// what boundary_loops throws.
SurfaceDivision divide_surface(const TriangleMesh& mesh, const MeshTopology& topology,
                               const std::vector<char>& cut, int count);

}  // namespace curveups
