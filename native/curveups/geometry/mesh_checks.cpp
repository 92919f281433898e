// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/mesh_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "curveups/core/tolerances.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/edge_sides.hpp"
#include "curveups/geometry/orientation.hpp"

namespace curveups {
namespace {

// A single-precision file resolves a coordinate to 6e-8 of its size: beyond this more than 0.01 mm.
constexpr double coarse_coordinates = 2e5;
constexpr double many_tiles = 20000, most_tiles = 200000;

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string listed(const std::vector<int>& items) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(items.size(), 5); ++i) {
    text += (i ? ", " : "") + std::to_string(items[i] + 1);
  }
  return text + (items.size() > 5 ? ", ..." : "");
}

class Findings {
 public:
  void add(const char* kind, std::string message, std::string remedy, std::vector<int> faces = {},
           std::vector<int> vertices = {}, bool is_error = true) {
    list.push_back({kind, std::move(message), std::move(remedy), std::move(faces),
                    std::move(vertices), is_error});
  }
  // One for a set of faces, none where it is empty.
  void add_faces(const char* kind, const std::string& what, const char* remedy,
                 std::vector<int> faces) {
    if (faces.empty()) return;
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    add(kind, std::to_string(faces.size()) + what + " (faces " + listed(faces) + ")", remedy,
        faces);
  }
  std::vector<MeshFinding> list;
};

void check_arrays(const TriangleMesh& mesh, Findings& findings) {
  if (mesh.F.rows() == 0 || mesh.V.rows() == 0) {
    findings.add("empty", "the surface has no faces", "check the file and its format");
    return;
  }
  std::vector<int> outside, infinite;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (mesh.F.row(f).minCoeff() < 0 || mesh.F.row(f).maxCoeff() >= mesh.V.rows()) {
      outside.push_back(f);
    }
  }
  findings.add_faces("index-out-of-range", " faces name vertices that do not exist",
                     "repair the file", outside);
  for (int v = 0; v < mesh.V.rows(); ++v) {
    if (!mesh.V.row(v).allFinite()) infinite.push_back(v);
  }
  if (!infinite.empty()) {
    findings.add("not-finite",
                 std::to_string(infinite.size()) + " vertices are not finite (vertices " +
                     listed(infinite) + ")",
                 "repair the file", {}, infinite);
  }
}

void check_manifold(const TriangleMesh& mesh, Findings& findings) {
  std::vector<int> degenerate, crowded, twisted;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    if (has_no_area(mesh, f)) degenerate.push_back(f);
  }
  visit_edges(mesh.F, static_cast<int>(mesh.V.rows()),
              [&](const EdgeSide* begin, const EdgeSide* end) {
                std::vector<int>* wrong = end - begin > 2 ? &crowded : nullptr;
                if (end - begin == 2 && begin[0].up == begin[1].up) wrong = &twisted;
                for (; wrong && begin != end; ++begin) wrong->push_back(begin->face);
              });
  findings.add_faces("degenerate-faces", " faces have no area", "remove them, or remesh",
                     degenerate);
  findings.add_faces("duplicate-faces", " faces are there twice", "remove the doubles",
                     repeated_faces(mesh.F, static_cast<int>(mesh.V.rows())));
  findings.add_faces("non-manifold-edges", " faces meet at edges of more than two faces",
                     "remove inner walls and doubled faces", crowded);
  if (!findings.list.empty()) return;
  if (!twisted.empty()) {
    if (orientation_of(mesh.V, mesh.F).consistent) {
      findings.add_faces("inconsistent-orientation", " faces are turned against their neighbours",
                         "make the normals consistent", twisted);
    } else {
      findings.add_faces("one-sided", " faces lie where front meets back: the surface has one side",
                         "cut the band through, or model it with two sides", twisted);
    }
    return;
  }
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
  const CutMesh fans = cut_open(mesh, topology, {});
  std::vector<char> on_boundary(mesh.V.rows(), 0);
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) on_boundary[edge.v[0]] = on_boundary[edge.v[1]] = 1;
  }
  std::vector<int> pinched, touching;
  for (std::size_t c = mesh.V.rows(); c < fans.original.size(); ++c) {
    (on_boundary[fans.original[c]] ? touching : pinched).push_back(fans.original[c]);
  }
  for (std::vector<int>* list : {&pinched, &touching}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  if (!pinched.empty()) {
    findings.add("non-manifold-vertices",
                 "parts of the surface touch in single vertices (vertices " + listed(pinched) + ")",
                 "separate the parts", {}, pinched);
  }
  if (!touching.empty()) {
    findings.add(
        "boundary-touches-itself",
        "the boundary touches itself in single vertices (vertices " + listed(touching) + ")",
        "fill the gap or widen it", {}, touching);
  }
}

void check_shape(const TriangleMesh& mesh, double L, bool cuts_given, bool without_crossings,
                 Findings& findings) {
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
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
  if (!closed.empty() && !cuts_given) {
    findings.add("closed", "the surface is closed: it can't lie flat in one piece",
                 "let it be cut open (--auto-cuts 1) or divided (pieces=auto), give --cuts, or "
                 "remove a part of it",
                 closed);
  }
  if (!without_crossings) {
    findings.add_faces("self-intersections", " faces run through others of the same surface",
                       "repair the surface: tiles can't pass through one another",
                       self_intersecting_faces(mesh));
  }
  const double largest = mesh.V.cwiseAbs().maxCoeff();
  if (largest > coarse_coordinates) {
    findings.add("huge-coordinates",
                 "coordinates reach " + number(largest) + " mm, where files lose digits",
                 "move the surface to the origin, or check its unit (scale)", {}, {},
                 largest > tolerance::largest_coordinate);
  }
  const double tiles = surface_area(mesh) / (std::sqrt(3.0) / 4 * L * L);
  const double size = (mesh.V.colwise().maxCoeff() - mesh.V.colwise().minCoeff()).norm();
  if (tiles < 0.3 || size < 0.9 * L) {
    findings.add("too-small",
                 "the surface is " + number(size) +
                     " mm large, smaller than one tile of L = " + number(L) + " mm",
                 "is it in metres or inches? set scale (1000 or 25.4), or choose a smaller L");
  } else if (tiles > many_tiles) {
    findings.add("too-large",
                 "the surface needs about " + number(tiles) + " tiles of L = " + number(L) + " mm",
                 "check the unit of the file (scale), or choose a larger L", {}, {},
                 tiles > most_tiles);
  }
  if (count > 1) {
    findings.add(
        "components",
        "the surface has " + std::to_string(count) + " components, which are laid out side by side",
        "", {}, {}, false);
  }
}

}  // namespace

std::vector<MeshFinding> check_mesh(const TriangleMesh& mesh, double L, bool cuts_given,
                                    bool without_crossings) {
  Findings findings;
  check_arrays(mesh, findings);
  if (findings.list.empty()) check_manifold(mesh, findings);
  if (findings.list.empty()) check_shape(mesh, L, cuts_given, without_crossings, findings);
  return findings.list;
}

}  // namespace curveups
