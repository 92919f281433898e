// SPDX-License-Identifier: LGPL-2.1-or-later
// Lines of a surface that are to stay edges of its tiling, so that a fold runs between tiles.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Interior edges (vertex pairs, lower vertex first, ascending) where the normals of the two faces
// differ by more than `angle` (rad), but for connected sets of them that are shorter than `least`
// (mm) altogether: noise. Faces without area have no creases.
Edges crease_edges(const TriangleMesh& mesh, const MeshTopology& topology, double angle,
                   double least);

struct FeatureLine {
  std::vector<int> vertices;  // along the line; of a closed one each once
  bool closed;
};

// The edges (vertex pairs) as lines that end where other than two of them meet and in vertices with
// `is_end`, each edge in one line. In the order of the lowest vertices.
std::vector<FeatureLine> feature_lines(const Edges& edges, const std::vector<char>& is_end);

}  // namespace curveups
