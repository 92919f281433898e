// SPDX-License-Identifier: LGPL-2.1-or-later
// Sharp edges of a surface made ready for tiles that can't bend round them.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct BevelOptions {
  double L = 7;               // edge length of the tiles, mm
  double keep_angle = 0.70;   // rad: edges where the surface turns by more stay edges of the tiling
  double bevel_angle = 1.22;  // rad: those where it turns by more are bevelled
  double half_width = 0.70;   // of a bevel, in L
  double reach = 0.5;         // in L: the turn is that of mean normals so far on either side
  double shortest = 2;        // in L: connected edges of less length are noise
};

struct BevelledMesh {
  TriangleMesh mesh;  // the given one, bit for bit, where nothing is bevelled
  Edges lines;        // edges that are to stay: both sides of bevels, and edges that are kept
  double length = 0;  // of the edges that are bevelled, mm
};

// Tiles that lie across a sharp edge bite it off in teeth. Where the surface turns too sharply for
// two tiles, three rows of edges share the turn evenly: all points within half_width of the edge
// move. The edge moves towards where a flat strip would be, and the strips on either side of it
// span what is between (harmonic: flat along a straight edge). The edge and both rims of the strips
// are lines. The boundary moves with the edges that end in it. Facets of a noisy scan make no
// edges, as normals are averaged. Deterministic. Throws what build_topology throws, InvalidInput (a
// length or an angle that is not positive, a mesh without faces), Cancelled.
BevelledMesh bevel_edges(const TriangleMesh& mesh, const BevelOptions& options);

}  // namespace curveups
