// SPDX-License-Identifier: LGPL-2.1-or-later
// From what scanners and exchanged files bring to a surface that can be remeshed: what clean_mesh
// leaves to check_mesh to refuse, as far as there is one sensible answer.
#pragma once

#include <string>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct MendOptions {
  double L = 7;           // mean edge length of the tiles, mm
  double hole_edge = 28;  // holes with a shorter edge are filled, mm
};

struct MendedMesh {
  TriangleMesh mesh;
  std::vector<std::string> actions;  // one per kind, with its count; empty: the mesh is as given
  // No face runs through another: that was looked for, and nothing was added since.
  bool without_crossings = false;
};

// In this order:
// - what clean_mesh does;
// - where more than two faces meet in an edge, faces are turned against one another, or parts touch
//   in single vertices, the surface is taken apart (CGAL's orient_polygon_soup); corners that come
//   apart move by a thousandth of an edge, so that they stay apart;
// - components smaller than two tiles and 2 % of the largest are removed;
// - faces that run through others are cut out with the faces around them and filled, where that
//   takes no more than some tiles' area and leaves nothing that intersects; else they stay;
// - holes are filled and faired (CGAL's triangulate_refine_and_fair_hole), but for the longest
//   boundary of each component.
// What can't be mended stays: check_mesh tells. Deterministic; mended again, the mesh stays as it
// is. Throws InvalidInput for an index out of range and L or hole_edge that are no lengths,
// Cancelled.
MendedMesh mend_mesh(const TriangleMesh& soup, const MendOptions& options);

}  // namespace curveups
