// SPDX-License-Identifier: LGPL-2.1-or-later
// The union of solids that are given by their surfaces.
#pragma once

#include <vector>

#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups {

// The surface of the union of closed meshes, each oriented outwards and free of self-intersections.
// None of them lies inside of another. Solids that touch no other keep their triangles. CGAL's
// corefinement decides exactly; new corners are rounded to doubles. Throws SolverFailure where a
// mesh is open or corefinement can't cut it, Cancelled. The same solids give the same numbers:
// vertices ascend by x, y and z (none shares its place with another), faces by their vertices.
TriangleMesh unite_meshes(const std::vector<TriangleMesh>& solids);

}  // namespace curveups
