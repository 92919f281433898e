// SPDX-License-Identifier: LGPL-2.1-or-later
// A surface in several pieces, each of which can be laid flat by itself.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// No piece gets fewer faces than these on average: it would be hardly more than a hinge.
inline constexpr int least_faces_of_piece = 12;

struct SurfaceDivision {
  std::vector<int> piece;  // of each face; from 0 in the order of the lowest faces
  Edges borders;           // where pieces meet, besides the cuts that were given
  Edges slits;             // cuts inside of pieces, after which each can be laid flat
};

// Divides the surface, of which the edges with cut[edge] != 0 are cut already (one entry per
// topology.edges, or empty), into `count` pieces of about the same area with short borders
// (face_regions); pieces that there are already count. All edges are vertex pairs, the lower first,
// ascending. Slits: where the new borders of a piece are several loops, shortest paths join them to
// one, as a ring lies flat with less stretch than a tube; opening_cuts does the rest (handles, and
// closed parts that stay whole). Holes of the surface may stay. Deterministic. Throws InvalidInput
// for a count below one or of less than least_faces_of_piece faces each, and what boundary_loops
// throws.
SurfaceDivision divide_surface(const TriangleMesh& mesh, const MeshTopology& topology,
                               const std::vector<char>& cut, int count);

}  // namespace curveups
