// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/fill_holes.hpp"

#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
#include <new>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/geometry/cgal_mesh.hpp"

namespace curveups {
namespace {

using cgal::Kernel, cgal::Mesh;
namespace pmp = CGAL::Polygon_mesh_processing;

}  // namespace

std::vector<std::vector<int>> small_holes(const TriangleMesh& mesh, double longest) {
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
  const std::vector<int> component = face_components(topology, {});
  std::map<int, int> component_at;  // a vertex of the boundary
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) component_at[edge.v[0]] = component[edge.face[0]];
  }
  std::vector<std::vector<int>> loops = boundary_loops(topology);
  std::vector<double> length;
  std::map<int, std::size_t> outer;  // of a component: its longest loop
  for (std::size_t k = 0; k < loops.size(); ++k) {
    length.push_back(loop_length(mesh.V, loops[k]));
    const auto [it, fresh] = outer.emplace(component_at[loops[k][0]], k);
    if (!fresh && length[k] > length[it->second]) it->second = k;
  }
  std::vector<std::vector<int>> out;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (length[k] < longest && outer[component_at[loops[k][0]]] != k) {
      out.push_back(std::move(loops[k]));
    }
  }
  return out;
}

int fill_holes(TriangleMesh& given, const std::vector<std::vector<int>>& holes) {
  if (holes.empty()) return 0;
  Mesh mesh;
  if (cgal::append(mesh, given) >= 0) return 0;
  int filled = 0;
  for (const std::vector<int>& hole : holes) {
    checkpoint();
    // The hole's side of an edge runs against that of its face.
    const auto side = mesh.halfedge(Mesh::Vertex_index(hole[1]), Mesh::Vertex_index(hole[0]));
    if (side == Mesh::null_halfedge() || !mesh.is_border(side)) continue;
    std::vector<Mesh::Face_index> faces;
    std::vector<Mesh::Vertex_index> vertices;
    try {
      pmp::triangulate_refine_and_fair_hole(mesh, side, std::back_inserter(faces),
                                            std::back_inserter(vertices));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      // CGAL found no triangulation: the hole stays, and what was begun is not taken over.
      return filled;
    }
    if (faces.empty()) continue;
    ++filled;
    const int first = static_cast<int>(given.V.rows()), rows = static_cast<int>(given.F.rows());
    given.V.conservativeResize(first + static_cast<Eigen::Index>(vertices.size()), 3);
    for (const auto v : vertices) {
      const Kernel::Point_3& p = mesh.point(v);
      given.V.row(static_cast<int>(v)) << p.x(), p.y(), p.z();
    }
    given.F.conservativeResize(rows + static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t k = 0; k < faces.size(); ++k) {
      int t = 0;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(faces[k]))) {
        given.F(rows + static_cast<Eigen::Index>(k), t++) = static_cast<int>(v);
      }
    }
  }
  return filled;
}

}  // namespace curveups
