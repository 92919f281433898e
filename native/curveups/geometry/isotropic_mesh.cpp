// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/isotropic_mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <exception>
#include <new>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
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

}  // namespace

IsotropicMesh isotropic_mesh(const IsotropicMesh& surface, double length, int iterations) {
  const Points3& V = surface.mesh.V;
  const Triangles& F = surface.mesh.F;
  Mesh mesh;
  mesh.reserve(V.rows(), 3 * F.rows() / 2, F.rows());
  auto fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first;
  for (int v = 0; v < V.rows(); ++v) {
    const auto vertex = mesh.add_vertex(Kernel::Point_3(V(v, 0), V(v, 1), V(v, 2)));
    fixed[vertex] = surface.fixed[v] != 0;
  }
  for (int f = 0; f < F.rows(); ++f) {
    const auto face = mesh.add_face(Mesh::Vertex_index(F(f, 0)), Mesh::Vertex_index(F(f, 1)),
                                    Mesh::Vertex_index(F(f, 2)));
    if (face == Mesh::null_face()) {
      throw TopologyError("the surface is not a manifold at face " + std::to_string(f + 1),
                          "separate faces that touch in one vertex only", {f});
    }
  }
  try {
    pmp::isotropic_remeshing(faces(mesh), length, mesh,
                             CGAL::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(3)
                                 .vertex_is_constrained_map(FixedVertices{fixed}));
  } catch (const Cancelled&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw SolverFailure("remeshing failed: " + std::string(error.what()),
                        "repair the surface, or give a remeshed one and switch remeshing off");
  }
  mesh.collect_garbage();
  IsotropicMesh out;
  out.mesh.V.resize(mesh.number_of_vertices(), 3);
  out.mesh.F.resize(mesh.number_of_faces(), 3);
  for (const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    out.mesh.V.row(v) << p.x(), p.y(), p.z();
    out.fixed.push_back(fixed[v]);
  }
  int row = 0;
  for (const auto f : mesh.faces()) {
    int t = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      out.mesh.F(row, t++) = static_cast<int>(v);
    }
    ++row;
  }
  return out;
}

}  // namespace curveups
