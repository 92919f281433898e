// SPDX-License-Identifier: LGPL-2.1-or-later
// Candidates for cuts that relieve a layout.
#pragma once

#include <vector>

#include "curveups/core/finding.hpp"
#include "curveups/design/tile_mesh.hpp"

namespace curveups {

struct CutCandidate {
  Edges edges;        // vertex pairs of the whole mesh, along the path
  double length = 0;  // mm
  Finding reason;
};

// Cuts along shortest edge paths to the nearest boundary or cut; none splits a piece. They begin,
// in this order, at weak contacts (whose own edges are cut as well), at interior extremes of the
// conformal scale, tips first, and at holes, which are joined to another boundary; of each kind the
// strongest ones. scale: relative_scale of the tiles, all of whose pieces must be open and without
// handles. weak: tile pairs.
std::vector<CutCandidate> cut_candidates(const TileMesh& tiles, const Eigen::VectorXd& scale,
                                         const std::vector<std::array<int, 2>>& weak);

// Length of edges of the mesh, mm.
double length_of(const TriangleMesh& mesh, const Edges& edges);

}  // namespace curveups
