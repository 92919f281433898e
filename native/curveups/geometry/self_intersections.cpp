// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <iterator>
#include <set>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cgal_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {

std::vector<int> self_intersecting_faces(const TriangleMesh& mesh) {
  if (mesh.F.rows() == 0) return {};
  cgal::Mesh surface;
  const int refused = cgal::append(surface, mesh);
  if (refused >= 0) {
    throw TopologyError("the surface is not a manifold at face " + std::to_string(refused + 1),
                        "repair the file", {refused});
  }
  std::vector<std::pair<cgal::Mesh::Face_index, cgal::Mesh::Face_index>> pairs;
  std::size_t reads = 0;
  CGAL::Polygon_mesh_processing::self_intersections(
      surface, std::back_inserter(pairs),
      CGAL::parameters::vertex_point_map(cgal::WatchedPoints{&surface, &reads}));
  std::set<int> faces;
  for (const auto& [a, b] : pairs) faces.insert({static_cast<int>(a), static_cast<int>(b)});
  return {faces.begin(), faces.end()};
}

}  // namespace curveups
