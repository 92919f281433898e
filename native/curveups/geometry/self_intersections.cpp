// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// The points of a mesh as CGAL asks for them: the one thing that it does all the time and that is
// ours, so that it can be stopped.
struct WatchedPoints {
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::readable_property_map_tag;
  const Mesh* mesh;
  std::size_t* asked;

  friend reference get(const WatchedPoints& points, key_type vertex) {
    checkpoint_now_and_then(++*points.asked);
    return points.mesh->point(vertex);
  }
};

}  // namespace

std::vector<int> self_intersecting_faces(const TriangleMesh& mesh) {
  Mesh surface;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    surface.add_vertex(Kernel::Point_3(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)));
  }
  for (int f = 0; f < mesh.F.rows(); ++f) {
    checkpoint_now_and_then(f);
    const auto face =
        surface.add_face(Mesh::Vertex_index(mesh.F(f, 0)), Mesh::Vertex_index(mesh.F(f, 1)),
                         Mesh::Vertex_index(mesh.F(f, 2)));
    if (face == Mesh::null_face()) {
      throw TopologyError("the surface is not a manifold at face " + std::to_string(f + 1),
                          "repair the file", {f});
    }
  }
  std::size_t asked = 0;
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(
      surface, std::back_inserter(pairs),
      CGAL::parameters::vertex_point_map(WatchedPoints{&surface, &asked}));
  std::vector<int> found;
  for (const auto& [a, b] : pairs) {
    found.push_back(static_cast<int>(a));
    found.push_back(static_cast<int>(b));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace curveups
