// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/mend_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/fill_holes.hpp"
#include "curveups/geometry/manifold_parts.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups {
namespace {

constexpr double tile_area = 0.433;  // of an equilateral triangle, in L^2

UsedPart without_faces(const TriangleMesh& mesh, const std::vector<char>& gone) {
  std::vector<int> kept;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (!gone[f]) kept.push_back(f);
  }
  return used_part(mesh.V, mesh.F(kept, Eigen::seqN(0, 3)));
}

MeshTopology topology_of(const TriangleMesh& mesh) {
  return build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
}

// Components that are too small for anything; returns how many.
int remove_crumbs(TriangleMesh& mesh, double L) {
  const std::vector<int> component = face_components(topology_of(mesh), {});
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
  std::vector<char> gone(mesh.F.rows(), 0), on_boundary(mesh.V.rows(), 0);
  for (int f : crossing) gone[f] = 1;
  for (const MeshEdge& edge : topology_of(mesh).edges) {
    if (edge.boundary()) on_boundary[edge.v[0]] = on_boundary[edge.v[1]] = 1;
  }
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
    for (std::vector<int>& loop : boundary_loops(topology_of(open))) {
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
