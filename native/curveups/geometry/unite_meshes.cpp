// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/unite_meshes.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

// The points of a mesh as corefinement asks for them: what it does all the time and is ours, so
// that it can be stopped.
struct WatchedPoints {
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;
  Mesh* mesh;
  std::size_t* asked;

  friend reference get(const WatchedPoints& points, key_type vertex) {
    checkpoint_now_and_then(++*points.asked);
    return points.mesh->point(vertex);
  }
  friend void put(const WatchedPoints& points, key_type vertex, const value_type& point) {
    points.mesh->point(vertex) = point;
  }
};

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

void append(Mesh& mesh, const TriangleMesh& solid) {
  std::vector<Mesh::Vertex_index> vertex(solid.V.rows());
  for (int v = 0; v < solid.V.rows(); ++v) {
    vertex[v] = mesh.add_vertex({solid.V(v, 0), solid.V(v, 1), solid.V(v, 2)});
  }
  for (int f = 0; f < solid.F.rows(); ++f) {
    const auto face =
        mesh.add_face(vertex[solid.F(f, 0)], vertex[solid.F(f, 1)], vertex[solid.F(f, 2)]);
    if (face == Mesh::null_face()) throw SolverFailure("a solid is no manifold", "report this");
  }
}

TriangleMesh taken_from(const Mesh& mesh) {
  TriangleMesh out{Points3(mesh.number_of_vertices(), 3), Triangles(mesh.number_of_faces(), 3)};
  std::vector<int> number(mesh.num_vertices());
  int v = 0, f = 0;
  for (const auto vertex : mesh.vertices()) {
    const auto& p = mesh.point(vertex);
    out.V.row(v) << p.x(), p.y(), p.z();
    number[vertex] = v++;
  }
  for (const auto face : mesh.faces()) {
    int t = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) {
      out.F(f, t++) = number[vertex];
    }
    ++f;
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
    for (const int k : group) append(next, solids[k]);
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
    both.collect_garbage();
    all = std::move(both);
  }
  return taken_from(all);
}

}  // namespace curveups
