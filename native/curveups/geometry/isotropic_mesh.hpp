// SPDX-License-Identifier: LGPL-2.1-or-later
// First half of remeshing: edges of about one length, by CGAL.
#pragma once

#include <array>
#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

struct IsotropicMesh {
  TriangleMesh mesh;
  std::vector<char> fixed;                   // per vertex
  std::vector<std::array<int, 2>> features;  // inner edges that stay edges, by their vertices
};

// Splits edges longer than 4/3 length, collapses edges shorter than 4/5, flips towards regular
// valence and relaxes, `iterations` times. Fixed vertices stay, boundary vertices stay on the
// boundary, vertices of features on their lines. Throws TopologyError, SolverFailure, Cancelled.
IsotropicMesh isotropic_mesh(const IsotropicMesh& surface, double length, int iterations);

}  // namespace curveups
