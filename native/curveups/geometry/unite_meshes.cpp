// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/unite_meshes.hpp"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cgal_mesh.hpp"

namespace curveups {
namespace {

using cgal::Mesh, cgal::WatchedPoints;
namespace pmp = CGAL::Polygon_mesh_processing;

// Sorts vertices by their coordinates and faces by their vertices: corefinement numbers them by
// addresses in memory, which differ from run to run.
TriangleMesh in_order(const TriangleMesh& mesh) {
  const int count = static_cast<int>(mesh.V.rows());
  std::vector<int> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int v) { return std::tuple(mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
  for (int k = 0; k < count; ++k) rank[order[k]] = k;
  std::vector<std::array<int, 3>> faces;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    std::array<int, 3> face = {rank[mesh.F(f, 0)], rank[mesh.F(f, 1)], rank[mesh.F(f, 2)]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return {mesh.V(order, Eigen::all),
          Eigen::Map<const Triangles>(faces.data()->data(), mesh.F.rows(), 3)};
}

Mesh closed_mesh(const TriangleMesh& solids) {
  Mesh mesh;
  if (cgal::append(mesh, solids) >= 0 || !CGAL::is_closed(mesh)) {
    throw SolverFailure("a solid is open or no manifold", "report this");
  }
  return mesh;
}

}  // namespace

TriangleMesh unite_meshes(const TriangleMesh& a, const TriangleMesh& b) {
  if (b.F.rows() == 0) return in_order(a);
  Mesh first = closed_mesh(a), second = closed_mesh(b), both;
  std::size_t reads = 0;
  bool united = false;
  try {
    using CGAL::parameters::vertex_point_map;
    united = pmp::corefine_and_compute_union(
        first, second, both,
        vertex_point_map(WatchedPoints{&first, &reads}).throw_on_self_intersection(true),
        vertex_point_map(WatchedPoints{&second, &reads}),
        vertex_point_map(WatchedPoints{&both, &reads}));
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
  }
  if (!united)
    throw SolverFailure("the solids can't be united",
                        "look for bodies that overlap: compute the layout again");
  return in_order(cgal::taken_from(both));
}

}  // namespace curveups
