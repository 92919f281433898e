// SPDX-License-Identifier: LGPL-2.1-or-later
// Vertices of the actuated surface as unknowns of a repair step, and the derivatives of the
// layout's constraints by them: tiles change their shape about their flat centroid and angle, which
// are held.
#pragma once

#include <vector>

#include "curveups/design/vertex_patch.hpp"
#include "curveups/layout/layout_terms.hpp"

namespace curveups {

struct MovingVertices {
  std::vector<int> vertex;           // numbers in the mesh
  std::vector<VertexPatch> patches;  // per vertex
  Points3 moved;                     // mm, from the place in the target
  Eigen::VectorXd weight;            // A_j of Eq. 4, mm2

  int count() const { return static_cast<int>(vertex.size()); }
};

// Entry `block` of make_constraints(model)[function].
struct ConstraintRow {
  int function, block;
};

struct VertexEntry {
  int row;     // number among the rows given
  int vertex;  // number among the moving vertices
  Vec3 derivative;
};

// Entries in the order of the vertices, then of the rows. Bounds of insets, keep-outs and the least
// areas of small pin sides are constant here: the geometry renews them after the step.
std::vector<VertexEntry> rows_by_vertex(const LayoutModel& model, const LayoutState& state,
                                        const std::vector<ConstraintRow>& rows,
                                        const MovingVertices& vertices);

// Derivative of a tile's front centroid, in its own frame, by its corner t (2 x 3).
Eigen::Matrix<double, 2, 3> centroid_by_corner(const TileMesh& tiles, int tile, int t);

}  // namespace curveups
