// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/sort_unique.hpp"
#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/face_soup.hpp"

namespace curveups {
namespace {

// Coordinate that a single-precision file resolves to 0.01 mm.
constexpr double coarse_coordinates = 2e5;
constexpr double many_tiles = 20000, most_tiles = 200000;

using Figures = std::map<std::string, Finding::Figure>;

class Findings {
 public:
  void add(const char* kind, Figures figures = {}, bool is_error = true) {
    list.push_back({kind, {}, std::move(figures), is_error});
  }
  // Adds rows of faces or vertices (`what`), unless there are none.
  void add_rows(const char* kind, const char* what, std::vector<int> rows) {
    if (rows.empty()) return;
    sort_unique(rows);
    const int count = static_cast<int>(rows.size());
    add(kind, {{"count", count}, {what, std::move(rows)}});
  }
  std::vector<Finding> list;
};

void check_arrays(const TriangleMesh& mesh, Findings& findings) {
  if (mesh.F.rows() == 0 || mesh.V.rows() == 0) {
    findings.add("empty");
    return;
  }
  std::vector<int> outside, infinite;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (mesh.F.row(f).minCoeff() < 0 || mesh.F.row(f).maxCoeff() >= mesh.V.rows()) {
      outside.push_back(f);
    }
  }
  findings.add_rows("index-out-of-range", "faces", outside);
  for (int v = 0; v < mesh.V.rows(); ++v) {
    if (!mesh.V.row(v).allFinite()) infinite.push_back(v);
  }
  findings.add_rows("not-finite", "vertices", infinite);
}

void check_manifold(const TriangleMesh& mesh, Findings& findings) {
  std::vector<int> degenerate, crowded, twisted;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (has_no_area(mesh, f)) degenerate.push_back(f);
  }
  visit_edges(mesh.F, [&](const EdgeSide* begin, const EdgeSide* end) {
    std::vector<int>* wrong = end - begin > 2 ? &crowded : nullptr;
    if (end - begin == 2 && begin[0].up == begin[1].up) wrong = &twisted;
    for (; wrong && begin != end; ++begin) wrong->push_back(begin->face);
  });
  findings.add_rows("degenerate-faces", "faces", degenerate);
  findings.add_rows("duplicate-faces", "faces", repeated_faces(mesh.F));
  findings.add_rows("non-manifold-edges", "faces", crowded);
  if (!findings.list.empty()) return;
  if (!twisted.empty()) {
    const bool two_sided = orientation_of(mesh.V, mesh.F).consistent;
    findings.add_rows(two_sided ? "inconsistent-orientation" : "one-sided", "faces", twisted);
    return;
  }
  const MeshTopology topology = build_topology(mesh.F);
  const CutMesh fans = cut_open(mesh, topology, {});
  const std::vector<char> on_boundary = boundary_vertices(topology, mesh.V.rows());
  std::vector<int> pinched, touching;
  for (std::size_t c = mesh.V.rows(); c < fans.original.size(); ++c) {
    (on_boundary[fans.original[c]] ? touching : pinched).push_back(fans.original[c]);
  }
  findings.add_rows("non-manifold-vertices", "vertices", pinched);
  findings.add_rows("boundary-touches-itself", "vertices", touching);
}

void check_shape(const TriangleMesh& mesh, double L, bool cuts_given, bool without_crossings,
                 Findings& findings) {
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<int> component = face_components(topology, {});
  const int count = *std::max_element(component.begin(), component.end()) + 1;
  std::vector<char> open(count, 0);
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) open[component[edge.face[0]]] = 1;
  }
  std::vector<int> closed;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (!open[component[f]]) closed.push_back(f);
  }
  if (!cuts_given) findings.add_rows("closed", "faces", closed);
  if (!without_crossings) {
    findings.add_rows("self-intersections", "faces", self_intersecting_faces(mesh));
  }
  const double largest = mesh.V.cwiseAbs().maxCoeff();
  if (largest > coarse_coordinates) {
    findings.add("huge-coordinates", {{"largest", largest}},
                 largest > tolerance::largest_coordinate);
  }
  const double tiles = surface_area(mesh) / (std::sqrt(3.0) / 4 * L * L);
  const double size = (mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff()).norm();
  if (tiles < 0.3 || size < 0.9 * L) {
    findings.add("too-small", {{"size", size}, {"L", L}});
  } else if (tiles > many_tiles) {
    findings.add("too-large", {{"tiles_needed", tiles}, {"L", L}}, tiles > most_tiles);
  }
  if (count > 1) findings.add("components", {{"count", count}}, false);
}

}  // namespace

std::vector<Finding> check_mesh(const TriangleMesh& mesh, double L, bool cuts_given,
                                bool without_crossings) {
  Findings findings;
  check_arrays(mesh, findings);
  if (findings.list.empty()) check_manifold(mesh, findings);
  if (findings.list.empty()) check_shape(mesh, L, cuts_given, without_crossings, findings);
  return findings.list;
}

}  // namespace curveups
