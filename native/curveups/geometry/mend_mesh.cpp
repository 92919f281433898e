// SPDX-License-Identifier: LGPL-2.1-or-later
// This file uses CGAL's Polygon Mesh Processing, which is GPL-3.0-or-later (see README, Licence).
#include "curveups/geometry/mend_mesh.hpp"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cgal_mesh.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {
namespace {

using cgal::Kernel, cgal::Mesh;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr double tile_area = 0.433;  // area of an equilateral triangle, in L^2

UsedPart without_faces(const TriangleMesh& mesh, const std::vector<char>& gone) {
  std::vector<int> kept;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (!gone[f]) kept.push_back(f);
  }
  return used_part(mesh.V, mesh.F(kept, Eigen::seqN(0, 3)));
}

// True if every edge has one face, or two that run along it in opposite directions, and every
// vertex one fan of faces.
bool is_manifold(const TriangleMesh& mesh) {
  try {
    // cut_open makes several vertices of one with several fans.
    return cut_open(mesh, build_topology(mesh.F), {}).mesh.V.rows() == mesh.V.rows();
  } catch (const TopologyError&) {
    return false;
  }
}

// Duplicates vertices until the mesh is a manifold (CGAL's orient_polygon_soup, which turns faces,
// too). Returns how many duplicates there are.
int part_manifolds(TriangleMesh& mesh) {
  std::vector<Kernel::Point_3> points;
  for (const auto p : mesh.V.rowwise()) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::array<std::size_t, 3>> polygons;
  for (const auto f : mesh.F.rowwise()) {
    polygons.push_back({static_cast<std::size_t>(f[0]), static_cast<std::size_t>(f[1]),
                        static_cast<std::size_t>(f[2])});
  }
  pmp::orient_polygon_soup(points, polygons);
  const int before = static_cast<int>(mesh.V.rows()), after = static_cast<int>(points.size());
  TriangleMesh out{Points3(after, 3), Triangles(mesh.F.rows(), 3)};
  for (int v = 0; v < after; ++v) out.V.row(v) << points[v].x(), points[v].y(), points[v].z();
  for (int f = 0; f < out.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) out.F(f, t) = static_cast<int>(polygons[f][t]);
  }
  draw_apart(out, before);
  mesh = std::move(out);
  return after - before;
}

// Boundary loops shorter than `longest` (mm), but for the longest one of each component.
std::vector<std::vector<int>> small_holes(const TriangleMesh& mesh, double longest) {
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<int> component = face_components(topology, {});
  std::map<int, int> component_at;  // a vertex of the boundary
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) component_at[edge.v[0]] = component[edge.face[0]];
  }
  std::vector<std::vector<int>> loops = boundary_loops(topology);
  std::vector<double> length;
  std::map<int, std::size_t> outer;  // longest loop by component
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

// Fills these boundary loops with triangles of about the size of those around and fairs them
// (P. Liepa, "Filling holes in meshes", SGP 2003; CGAL's implementation). Returns how many could be
// filled; given vertices and faces keep their places and numbers.
int fill_holes(TriangleMesh& given, const std::vector<std::vector<int>>& holes) {
  if (holes.empty()) return 0;
  Mesh mesh;
  if (cgal::append(mesh, given) >= 0) return 0;
  int filled = 0;
  for (auto hole = holes.begin(); hole != holes.end(); ++hole) {
    checkpoint();
    // The hole's side of an edge runs against that of its face.
    const auto side = mesh.halfedge(Mesh::Vertex_index((*hole)[1]), Mesh::Vertex_index((*hole)[0]));
    if (side == Mesh::null_halfedge() || !mesh.is_border(side)) continue;
    std::vector<Mesh::Face_index> faces;
    std::vector<Mesh::Vertex_index> vertices;
    try {
      pmp::triangulate_refine_and_fair_hole(mesh, side, std::back_inserter(faces),
                                            std::back_inserter(vertices));
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {  // CGAL found no triangulation: this hole stays
      return fill_holes(given, {holes.begin(), hole});
    }
    filled += faces.empty() ? 0 : 1;
  }
  given = cgal::taken_from(mesh);
  return filled;
}

// Components that are too small for anything; returns how many.
int remove_crumbs(TriangleMesh& mesh, double L) {
  const std::vector<int> component = face_components(build_topology(mesh.F), {});
  if (component.empty()) return 0;
  std::vector<double> area(*std::max_element(component.begin(), component.end()) + 1, 0);
  for (int f = 0; f < mesh.F.rows(); ++f) area[component[f]] += face_area_vector(mesh, f).norm();
  const double least =
      std::min(2 * tile_area * L * L, 0.02 * *std::max_element(area.begin(), area.end()));
  const auto count = std::count_if(area.begin(), area.end(), [&](double a) { return a < least; });
  if (count == 0) return 0;
  std::vector<char> gone(mesh.F.rows(), 0);
  for (int f = 0; f < mesh.F.rows(); ++f) gone[f] = area[component[f]] < least;
  mesh = without_faces(mesh, gone).mesh;
  return static_cast<int>(count);
}

// Marks all faces at the vertices of marked ones.
void grow(const TriangleMesh& mesh, std::vector<char>& marked) {
  std::vector<char> near(mesh.V.rows(), 0);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    for (int t = 0; t < 3; ++t) near[mesh.F(f, t)] |= marked[f];
  }
  for (int f = 0; f < mesh.F.rows(); ++f) {
    marked[f] |= near[mesh.F(f, 0)] || near[mesh.F(f, 1)] || near[mesh.F(f, 2)];
  }
}

// Cuts faces that run through others out and fills the gaps, with more and more of what is around
// them; returns how many faces did, 0 where it did not help. left: whether some still do.
int replace_intersections(TriangleMesh& mesh, double L, bool& left) {
  const std::vector<int> crossing = self_intersecting_faces(mesh);
  left = !crossing.empty();
  if (!left) return 0;
  std::vector<char> gone(mesh.F.rows(), 0);
  for (int f : crossing) gone[f] = 1;
  const std::vector<char> on_boundary = boundary_vertices(build_topology(mesh.F), mesh.V.rows());
  for (int rings = 1; rings <= 4; ++rings) {
    grow(mesh, gone);
    double area = 0;
    for (int f = 0; f < mesh.F.rows(); ++f) {
      if (gone[f]) area += face_area_vector(mesh, f).norm();
    }
    if (area > 12 * tile_area * L * L) return 0;
    auto [open, number] = without_faces(mesh, gone);
    if (!is_manifold(open)) continue;
    std::vector<char> was_boundary(open.V.rows(), 0);
    for (int v = 0; v < mesh.V.rows(); ++v) {
      if (number[v] >= 0) was_boundary[number[v]] = on_boundary[v];
    }
    std::vector<std::vector<int>> gaps;
    bool inside = true;  // no gap reaches the boundary
    for (std::vector<int>& loop : boundary_loops(build_topology(open.F))) {
      const auto old = static_cast<std::size_t>(
          std::count_if(loop.begin(), loop.end(), [&](int v) { return was_boundary[v] != 0; }));
      if (old == loop.size()) continue;
      inside = inside && old == 0;
      gaps.push_back(std::move(loop));
    }
    if (!inside || gaps.empty()) continue;
    if (fill_holes(open, gaps) != static_cast<int>(gaps.size())) continue;
    if (!self_intersecting_faces(open).empty()) continue;
    mesh = std::move(open);
    left = false;
    return static_cast<int>(crossing.size());
  }
  return 0;
}

}  // namespace

MendedMesh mend_mesh(const TriangleMesh& soup, const MendOptions& options) {
  if (!(options.L > 0) || !std::isfinite(options.L) || !(options.hole_edge >= 0) ||
      !std::isfinite(options.hole_edge)) {
    throw InvalidInput("L and the edge of holes must be lengths", "give them in mm");
  }
  checkpoint("mending the target");
  MendedMesh out;
  CleanMesh clean = clean_mesh(soup);
  out.actions = std::move(clean.notes);
  out.mesh = std::move(clean.mesh);
  if (!out.mesh.V.allFinite() || out.mesh.F.rows() == 0) return out;  // check_mesh says so
  const auto note = [&](int count, const char* what) {
    if (count > 0) out.actions.push_back(std::to_string(count) + what);
  };
  if (!is_manifold(out.mesh)) {
    note(part_manifolds(out.mesh), " corners taken apart where more than two faces or parts met");
    if (!is_manifold(out.mesh)) return out;
  }
  note(remove_crumbs(out.mesh, options.L), " loose parts smaller than two tiles removed");
  checkpoint("mending the target", 0.4);
  bool crossings = false;
  note(replace_intersections(out.mesh, options.L, crossings),
       " faces that ran through others cut out and filled");
  checkpoint("mending the target", 0.8);
  const int filled = fill_holes(out.mesh, small_holes(out.mesh, options.hole_edge));
  note(filled, " holes filled");
  out.without_crossings = !crossings && filled == 0;
  return out;
}

}  // namespace curveups
