// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertices of the actuated surface as unknowns of a repair step, and what they do to the layout's
// constraints: tiles change their shape about their flat centroid and angle, which are held.
#pragma once

#include <vector>

#include "curveups/design/vertex_patch.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {

struct MovingVertices {
  std::vector<int> vertex;           // of the mesh
  std::vector<VertexPatch> patches;  // one each
  Points3 moved;                     // where each is, from its place in the target, mm
  Eigen::VectorXd weight;            // A_j of Eq. 4, mm2

  int count() const { return static_cast<int>(vertex.size()); }
};

// Entry `block` of make_constraints(model)[function].
struct ConstraintRow {
  int function, block;
};

struct VertexEntry {
  int row;     // of the rows given
  int vertex;  // of the moving vertices
  Vec3 derivative;
};

// In the order of the vertices, then of the rows. Bounds of insets, keep-outs and what small pin
// sides must have are taken as they are: those are renewed with the geometry after the step.
std::vector<VertexEntry> rows_by_vertex(const LayoutModel& model, const LayoutState& state,
                                        const std::vector<ConstraintRow>& rows,
                                        const MovingVertices& vertices);

// How a tile's front centroid, in its own frame, moves with its corner t (2 x 3).
Eigen::Matrix<double, 2, 3> centroid_by_corner(const TileMesh& tiles, int tile, int t);

}  // namespace curveups
