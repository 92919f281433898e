// SPDX-License-Identifier: LGPL-2.1-or-later
// Mends scanned and exchanged meshes where there is one sensible answer, so that they can be
// remeshed.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct MendOptions {
  double L = 7;           // mean edge length of the tiles, mm
  double hole_edge = 28;  // holes with a shorter boundary are filled, mm
};

struct MendedMesh {
  TriangleMesh mesh;
  std::vector<std::string> actions;  // with counts, one of a kind; empty: the mesh is as given
  // True: no face runs through another, which was checked after the last change.
  bool without_crossings = false;
};

// Steps:
// - clean_mesh;
// - take the surface apart where more than two faces meet in an edge, faces are turned against one
//   another, or parts touch in single vertices;
// - remove components smaller than two tiles and 2 % of the largest;
// - cut out faces that run through others with the faces around them and fill the gaps, where that
//   takes no more than some tiles' area and leaves no intersection; else they stay;
// - fill holes, but for the longest boundary of each component.
// check_mesh reports the rest. Deterministic; mended again, the mesh stays as it is. Throws
// InvalidInput for an index out of range and for L or hole_edge that are no lengths, Cancelled.
MendedMesh mend_mesh(const TriangleMesh& soup, const MendOptions& options);

}  // namespace curveups
