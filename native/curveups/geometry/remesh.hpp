// SPDX-License-Identifier: LGPL-2.1-or-later
// Uniform isotropic triangulation of a surface. Its triangles become the tiles.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct RemeshOptions {
  double L = 7.0;  // mean edge length, mm
  // Creases: edges whose two faces' normals differ by more than this (rad) stay edges; lines of
  // them shorter than 2 L altogether are taken for noise. pi or more: none.
  double crease_angle = 4;
  Edges features = Edges(0, 2);  // more edges that stay, by vertices of the surface
  double corner_reach = 0;       // mm, see space_lines: for ragged boundaries
};

struct RemeshResult {
  TriangleMesh mesh;
  double mean_edge;    // mm
  double edge_cv;      // standard deviation of the edge lengths over their mean
  double chord_error;  // largest distance of the input surface from the facets, mm
  Edges features;      // the edges that lie on creases and given features, by vertices of `mesh`
};

// Splits, collapses and flips edges (M. Botsch, L. Kobbelt, "A remeshing approach to
// multiresolution modeling", SGP 2004), then evens the edges out by springs of equal rest length
// that move vertices along the surface. Every component and every boundary loop stays; boundary
// vertices stay on the input's boundary, its corners (turns above 40 degrees) stay vertices; the
// same holds for features, which stay lines of edges. Moves
// that would flatten a face or turn it over are cut short.
// Deterministic. Throws what build_topology and boundary_loops throw, InvalidInput (vertices not
// finite, faces without area, edges longer than 300 L, L not positive or so small that more than
// 200,000 faces would arise),
// TopologyError where a component or a loop is too small for edges of this length, Cancelled.
RemeshResult remesh(const TriangleMesh& surface, const RemeshOptions& options);

}  // namespace curveups
