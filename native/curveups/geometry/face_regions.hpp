// SPDX-License-Identifier: LGPL-2.1-or-later
// Regions of about the same area with short borders, each connected by edges.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// The number of each face's region, from 0. Faces are nearer to their region's middle than to any
// other: distances along the surface from middles that start as far from one another as can be and
// move to the face deepest inside of their region (S. P. Lloyd, "Least squares quantization in
// PCM", 1982); larger regions are held back by an additive weight. Then teeth are taken off: a face
// goes to the region that it shares two sides with. Of all rounds the one of the shortest border,
// weighed with the largest area over the mean. cut: one entry per topology.edges, or empty; regions
// do not reach across cuts. count: at least that of the mesh's components under `cut`.
std::vector<int> face_regions(const TriangleMesh& mesh, const MeshTopology& topology,
                              const std::vector<char>& cut, int count);

}  // namespace curveups
