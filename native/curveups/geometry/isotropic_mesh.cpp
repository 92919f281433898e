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

// Which vertices stay; CGAL asks at every turn, and so lets itself be stopped.
struct FixedVertices {
  using key_type = Mesh::Vertex_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  friend bool get(const FixedVertices& map, key_type vertex) {
    if (++map.asked % 1024 == 0) checkpoint();
    return map.fixed[vertex];
  }
  // CGAL's manual asks for it; whether it is called depends on the version.
  [[maybe_unused]] friend void put(const FixedVertices& map, key_type vertex, bool value) {
    map.fixed[vertex] = value;
  }

  Mesh::Property_map<Mesh::Vertex_index, bool> fixed;
  mutable unsigned asked = 0;
};

// The vertices' points. CGAL's relaxation (5.5) reads the edge of no halfedge after it has moved a
// vertex to where none of its faces has an area: such moves, which bodies of the size of a tile
// come to, are not made.
struct SoundPoints {
  using key_type = Mesh::Vertex_index;
  using value_type = Kernel::Point_3;
  using reference = const Kernel::Point_3&;
  using category = boost::read_write_property_map_tag;

  // Whether v, with this point, would only have triangles without area, as far as rounding tells.
  bool flattens(key_type v, const Kernel::Point_3& p) const {
    if (mesh->is_isolated(v)) return false;
    for (const auto h : mesh->halfedges_around_target(mesh->halfedge(v))) {
      if (mesh->is_border(h)) return false;  // stays where it is
      const auto next = mesh->next(h);
      if (mesh->next(mesh->next(next)) != h) return false;  // its edge is being split
      const Kernel::Vector_3 a = mesh->point(mesh->target(next)) - p;
      const Kernel::Vector_3 b = mesh->point(mesh->source(h)) - p;
      const double longest = std::max(a.squared_length(), b.squared_length());
      if (CGAL::cross_product(a, b).squared_length() > 1e-28 * longest * longest) return false;
    }
    return true;
  }

  friend reference get(const SoundPoints& map, key_type v) { return map.mesh->point(v); }
  friend void put(const SoundPoints& map, key_type v, const value_type& p) {
    if (!map.flattens(v, p)) {
      map.mesh->point(v) = p;
    } else if (map.flattens(v, map.mesh->point(v))) {
      throw TopologyError("a part of the surface shrinks to a line at edges of this length",
                          "choose a smaller L, or remove the part");
    }
  }

  Mesh* mesh;
};

// CGAL 6 removes a face without area at the boundary, such as collapsing leaves where three
// boundary vertices are on a line, and then asks for its edges, at times for ever. Here no face is
// one, and collapses that would make one turn a face over, which CGAL does not do.
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
  try {
    pmp::isotropic_remeshing(faces(mesh), length, mesh,
                             CGAL::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(3)
                                 .geom_traits(Traits())
                                 .vertex_point_map(SoundPoints{&mesh})
                                 .edge_is_constrained_map(feature)
                                 .vertex_is_constrained_map(FixedVertices{fixed}));
  } catch (const std::logic_error& error) {  // of CGAL
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
