// SPDX-License-Identifier: LGPL-2.1-or-later
// Spectral conformal parametrization: P. Mullen, Y. Tong, P. Alliez, M. Desbrun, "Spectral
// conformal parameterization", Computer Graphics Forum 27 (5), 2008. The start of the flat layout;
// the paper uses least-squares conformal maps, whose two pinned vertices spread the scale further.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Flat positions (N x 2, mm) of the vertices of one connected, oriented piece with at least one
// boundary loop: among all maps whose longest boundary loop has unit moment about its centroid the
// one of least conformal energy, holes being closed for its sake. Faces keep their orientation
// (counter-clockwise), the area of the map is the area of the surface, its centroid is the origin,
// and the first edge of the first face points along x. Vertices that no face uses lie at the
// origin. A flat mesh is mapped by a rigid motion. Conformal maps of smooth surfaces never fold,
// discrete ones may in needles: conformal_scale tells. Throws TopologyError (what build_topology
// and boundary_loops refuse, several components, a closed surface, a surface with handles: those
// need cuts), InvalidInput (a vertex that is not finite, a face without area), SolverFailure.
Points2 conformal_map(const TriangleMesh& mesh);

// Per face the factor by which the map scales lengths: the root of the ratio of the areas; negative
// where the map turns the face over.
Eigen::VectorXd conformal_scale(const TriangleMesh& mesh, const Points2& map);

}  // namespace curveups
