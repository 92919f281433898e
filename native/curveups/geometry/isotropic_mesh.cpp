// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/isotropic_mesh.hpp"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/version.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cgal_mesh.hpp"

namespace curveups {
namespace {

using cgal::Kernel, cgal::Mesh;
namespace pmp = CGAL::Polygon_mesh_processing;

// CGAL's relaxation (5.5) reads the edge of no halfedge once all faces of a vertex have lost their
// area, which happens on bodies of the size of a tile: such moves are left out.
struct SoundPoints : cgal::WatchedPoints {
  // True if v at this point would only have triangles without area, as far as rounding tells.
  bool flattens(key_type v, const value_type& p) const {
    if (mesh->is_isolated(v)) return false;
    for (const auto h : mesh->halfedges_around_target(mesh->halfedge(v))) {
      if (mesh->is_border(h)) return false;  // v does not move
      const auto next = mesh->next(h);
      if (mesh->next(mesh->next(next)) != h) return false;  // an edge that is being split
      const Kernel::Vector_3 a = mesh->point(mesh->target(next)) - p;
      const Kernel::Vector_3 b = mesh->point(mesh->source(h)) - p;
      const double longest = std::max(a.squared_length(), b.squared_length());
      if (CGAL::cross_product(a, b).squared_length() > 1e-28 * longest * longest) return false;
    }
    return true;
  }

  friend void put(const SoundPoints& map, key_type v, const value_type& p) {
    if (!map.flattens(v, p)) {
      map.mesh->point(v) = p;
    } else if (map.flattens(v, map.mesh->point(v))) {
      throw TopologyError("a part of the surface shrinks to a line at edges of this length",
                          "choose a smaller L, or remove the part");
    }
  }
};

// CGAL 6 removes faces without area at the boundary, which collapsing leaves where three boundary
// vertices lie on a line, and then reads their edges, at times forever. With this predicate no face
// counts as one; collapses that would make one turn a face over, and CGAL leaves those out.
struct Traits : Kernel {
#if CGAL_VERSION_NR >= 1060000000
  struct Collinear_3 {
    bool operator()(const Kernel::Point_3&, const Kernel::Point_3&, const Kernel::Point_3&) const {
      return false;
    }
  };
  [[nodiscard]] Collinear_3 collinear_3_object() const { return {}; }
#endif
};

}  // namespace

IsotropicMesh isotropic_mesh(const IsotropicMesh& surface, double length, int iterations) {
  Mesh mesh;
  const int refused = cgal::append(mesh, surface.mesh);
  if (refused >= 0) {
    throw TopologyError("the surface is not a manifold at face " + std::to_string(refused + 1),
                        "separate faces that touch in one vertex only", {refused});
  }
  auto fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first;
  for (const auto v : mesh.vertices()) fixed[v] = surface.fixed[v] != 0;
  auto feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for (const auto& [a, b] : surface.features) {
    const auto side = mesh.halfedge(Mesh::Vertex_index(a), Mesh::Vertex_index(b));
    if (side != Mesh::null_halfedge()) feature[mesh.edge(side)] = true;
  }
  std::size_t reads = 0;
  try {
    pmp::isotropic_remeshing(faces(mesh), length, mesh,
                             CGAL::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(3)
                                 .geom_traits(Traits())
                                 .vertex_point_map(SoundPoints{{&mesh, &reads}})
                                 .edge_is_constrained_map(feature)
                                 .vertex_is_constrained_map(fixed));
  } catch (const std::logic_error& error) {  // CGAL's failed assertions
    throw SolverFailure("remeshing failed: " + std::string(error.what()),
                        "repair the surface, or give a remeshed one and switch remeshing off");
  }
  IsotropicMesh out;
  out.mesh = cgal::taken_from(mesh);
  for (const auto v : mesh.vertices()) out.fixed.push_back(fixed[v]);
  for (const auto e : mesh.edges()) {
    if (!feature[e]) continue;
    out.features.push_back(
        {static_cast<int>(mesh.vertex(e, 0)), static_cast<int>(mesh.vertex(e, 1))});
  }
  return out;
}

}  // namespace curveups
