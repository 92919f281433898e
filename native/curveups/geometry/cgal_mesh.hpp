// SPDX-License-Identifier: LGPL-2.1-or-later
// Triangle meshes for CGAL's algorithms, for files of this room alone. This file uses CGAL's
// Surface_mesh, which is GPL-3.0-or-later (see README, Licence).
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/geometry/triangle_mesh.hpp"

namespace curveups::cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Appends vertices and faces. Returns the first face that would make the mesh no manifold, or -1.
// Throws Cancelled.
inline int append(Mesh& to, const TriangleMesh& mesh) {
  const auto vertex = [first = static_cast<int>(to.num_vertices())](int v) {
    return Mesh::Vertex_index(first + v);
  };
  for (int v = 0; v < mesh.V.rows(); ++v) {
    to.add_vertex({mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)});
  }
  for (int f = 0; f < mesh.F.rows(); ++f) {
    checkpoint_now_and_then(f);
    const auto face = to.add_face(vertex(mesh.F(f, 0)), vertex(mesh.F(f, 1)), vertex(mesh.F(f, 2)));
    if (face == Mesh::null_face()) return f;
  }
  return -1;
}

// Collects the mesh's garbage and copies the mesh in CGAL's order.
inline TriangleMesh taken_from(Mesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh out{Points3(mesh.num_vertices(), 3), Triangles(mesh.num_faces(), 3)};
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    out.V.row(v) << p.x(), p.y(), p.z();
  }
  for (const auto f : mesh.faces()) {
    int t = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      out.F(static_cast<int>(f), t++) = static_cast<int>(v);
    }
  }
  return out;
}

// Property map of a mesh's points that calls checkpoint() now and then: CGAL reads points all the
// time, and so can be stopped.
struct WatchedPoints {
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::read_write_property_map_tag;
  Mesh* mesh;
  std::size_t* reads;
  friend reference get(const WatchedPoints& points, key_type vertex) {
    checkpoint_now_and_then(++*points.reads);
    return points.mesh->point(vertex);
  }
  friend void put(const WatchedPoints& points, key_type vertex, const value_type& point) {
    points.mesh->point(vertex) = point;
  }
};

}  // namespace curveups::cgal
