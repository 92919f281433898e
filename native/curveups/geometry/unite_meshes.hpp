// SPDX-License-Identifier: LGPL-2.1-or-later
// Union of solids given by their surfaces.
#pragma once

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// Surface of the union of a and b, both closed meshes, oriented outwards and free of
// self-intersections, of one solid or of several disjoint ones; b may be empty. CGAL's corefinement
// decides exactly; new corners are rounded to doubles. Throws SolverFailure where a mesh is open or
// corefinement can't cut it, Cancelled. Deterministic: vertices ascend by x, y and z, faces by
// their vertices.
TriangleMesh unite_meshes(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace curveups
