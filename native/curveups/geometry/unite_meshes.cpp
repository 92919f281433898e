// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/unite_meshes.hpp"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cgal_mesh.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

using cgal::Mesh, cgal::WatchedPoints;
namespace pmp = CGAL::Polygon_mesh_processing;

// Groups of solids whose boxes do not touch: what is united with the rest in one go must not cut
// itself.
std::vector<std::vector<int>> disjoint_groups(const std::vector<TriangleMesh>& solids) {
  const int count = static_cast<int>(solids.size());
  Points3 low(count, 3), high(count, 3);
  for (int k = 0; k < count; ++k) {
    low.row(k) = solids[k].V.colwise().minCoeff();
    high.row(k) = solids[k].V.colwise().maxCoeff();
  }
  std::vector<std::vector<int>> earlier(count);
  for (const auto& [i, j] : overlapping_boxes(low, high)) earlier[j].push_back(i);
  std::vector<std::vector<int>> groups;
  std::vector<std::size_t> group_of(count, 0);
  for (int k = 0; k < count; ++k) {
    std::vector<char> taken(groups.size() + 1, 0);
    for (const int other : earlier[k]) taken[group_of[other]] = 1;
    group_of[k] = std::find(taken.begin(), taken.end(), 0) - taken.begin();
    if (group_of[k] == groups.size()) groups.emplace_back();
    groups[group_of[k]].push_back(k);
  }
  return groups;
}

bool comes_before(const Points3& V, int a, int b) {
  for (int k = 0; k < 3; ++k) {
    if (V(a, k) != V(b, k)) return V(a, k) < V(b, k);
  }
  return a < b;
}

// Vertices by their places, faces by their vertices from the first one on: corefinement numbers
// them by addresses in memory, which differ from run to run.
TriangleMesh in_order(const TriangleMesh& mesh) {
  const int count = static_cast<int>(mesh.V.rows());
  std::vector<int> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return comes_before(mesh.V, a, b); });
  for (int k = 0; k < count; ++k) rank[order[k]] = k;
  std::vector<std::array<int, 3>> faces;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    std::array<int, 3> face = {rank[mesh.F(f, 0)], rank[mesh.F(f, 1)], rank[mesh.F(f, 2)]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  TriangleMesh out{mesh.V(order, Eigen::all), Triangles(mesh.F.rows(), 3)};
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (int t = 0; t < 3; ++t) out.F(static_cast<int>(f), t) = faces[f][t];
  }
  return out;
}

}  // namespace

TriangleMesh unite_meshes(const std::vector<TriangleMesh>& solids) {
  Mesh all;
  std::size_t asked = 0;
  for (const std::vector<int>& group : disjoint_groups(solids)) {
    checkpoint();
    Mesh next;
    for (const int k : group) {
      if (cgal::append(next, solids[k]) >= 0) {
        throw SolverFailure("a solid is no manifold", "report this");
      }
    }
    if (!CGAL::is_closed(next)) throw SolverFailure("a solid is open", "report this");
    if (all.is_empty()) {
      all = std::move(next);
      continue;
    }
    Mesh both;
    bool united = false;
    try {
      using CGAL::parameters::vertex_point_map;
      united = pmp::corefine_and_compute_union(
          all, next, both,
          vertex_point_map(WatchedPoints{&all, &asked}).throw_on_self_intersection(true),
          vertex_point_map(WatchedPoints{&next, &asked}),
          vertex_point_map(WatchedPoints{&both, &asked}));
    } catch (const pmp::Corefinement::Self_intersection_exception&) {
      united = false;
    }
    if (!united) throw SolverFailure("the solids can't be united", "report this");
    all = Mesh();
    cgal::append(all, in_order(cgal::taken_from(both)));
  }
  return in_order(cgal::taken_from(all));
}

}  // namespace curveups
