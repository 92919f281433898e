// SPDX-License-Identifier: LGPL-2.1-or-later
// Uniform isotropic triangulation of a surface, whose triangles become the tiles.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct RemeshOptions {
  double L = 7.0;  // mean edge length, mm
  // Creases stay edges: normals of two faces differ by more than this (rad), on connected lines of
  // 2 L or more altogether. pi or more: none.
  double crease_angle = 4;
  Edges features = Edges(0, 2);  // more edges that stay, vertex pairs
  double corner_reach = 0;       // mm, see space_lines: for ragged boundaries
};

struct RemeshResult {
  TriangleMesh mesh;
  double mean_edge;    // mm
  double edge_cv;      // standard deviation of the edge lengths over their mean
  double chord_error;  // largest distance of the input surface from the facets, mm
  Edges features;      // edges on creases and given features, by vertices of `mesh`
};

// Splits, collapses and flips edges (M. Botsch, L. Kobbelt, "A remeshing approach to
// multiresolution modeling", SGP 2004), then moves vertices along the surface by springs of equal
// rest length. Every component and every boundary loop stays. Boundary vertices stay on the input's
// boundary, and its corners (turns above 40 degrees) stay vertices; likewise for features, which
// stay lines of edges. Deterministic. Throws what build_topology and boundary_loops throw,
// InvalidInput (vertices not finite, faces without area, edges longer than 300 L, L not positive or
// so small that more than 200,000 faces would arise), TopologyError where a component or a loop is
// too small for edges of this length, Cancelled.
RemeshResult remesh(const TriangleMesh& surface, const RemeshOptions& options);

}  // namespace curveups
