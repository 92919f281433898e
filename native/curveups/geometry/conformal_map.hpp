// SPDX-License-Identifier: LGPL-2.1-or-later
// Spectral conformal parametrization: P. Mullen, Y. Tong, P. Alliez, M. Desbrun, "Spectral
// conformal parameterization", Computer Graphics Forum 27 (5), 2008. The start of the flat layout;
// the paper uses least-squares conformal maps, whose two pinned vertices spread the scale further.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Flat positions (N x 2, mm) of the vertices of one connected, oriented piece with a boundary. The
// map has the least conformal energy among all whose longest boundary loop has unit moment about
// its centroid; the other loops are closed meanwhile. Faces stay counter-clockwise, the area is the
// surface's, the centroid is the origin, and the first edge of the first face points along x.
// Unused vertices lie at the origin. A flat mesh moves rigidly. Needles may fold (see
// conformal_scale). Throws TopologyError (what build_topology and boundary_loops refuse, several
// components, a closed surface, handles), SolverFailure (faces without area above all).
Points2 conformal_map(const TriangleMesh& mesh);

// Scale of lengths per face, the root of the ratio of areas; negative where the face is turned
// over.
Eigen::VectorXd conformal_scale(const TriangleMesh& mesh, const Points2& map);

}  // namespace curveups
