// SPDX-License-Identifier: LGPL-2.1-or-later
// Built-in targets, and what makes a target of a mesh.
#include "curveups/bindings/arrays.hpp"
#include "curveups/core/parallel.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/divide_surface.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "curveups/geometry/mend_mesh.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/polygon_triangulation.hpp"
#include "curveups/geometry/registration.hpp"
#include "curveups/geometry/remesh.hpp"
#include "curveups/geometry/surface_deviation.hpp"

namespace curveups::bindings {
namespace {

std::vector<ClosestPoint> closest_points(const PointsIn& points, const PointsIn& V,
                                         const TrianglesIn& F) {
  const Points3 from = read_points(points, "points");
  const TriangleMesh mesh = read_mesh(V, F);
  const py::gil_scoped_release release;
  const ClosestPoints closest(mesh);
  std::vector<ClosestPoint> found(static_cast<std::size_t>(from.rows()));
  parallel_ranges(static_cast<int>(from.rows()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) found[k] = closest(from.row(k));
  });
  return found;
}

}  // namespace

void bind_meshes(py::module_& module) {
  module.def(
      "builtin_targets",
      [] {
        std::vector<std::pair<std::string, std::string>> list;
        for (const BuiltinTarget& t : builtin_targets()) list.emplace_back(t.name, t.meaning);
        return list;
      },
      "Names and one-line meanings of the built-in targets.");
  module.def(
      "builtin_target",
      [](const std::string& name, double tolerance) {
        TriangleMesh mesh = builtin_target(name, tolerance);
        return std::make_pair(std::move(mesh.V), std::move(mesh.F));
      },
      py::arg("name"), py::arg("tolerance") = 0.0035,
      "V and F of a fine triangulation within `tolerance` mm of the exact surface.");
  module.def(
      "mean_edge_length",
      [](const PointsIn& V, const TrianglesIn& F) { return mean_edge_length(read_mesh(V, F)); },
      py::arg("V"), py::arg("F"), "Mean length of the edges, mm.");
  module.def(
      "distances",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        const py::gil_scoped_release release;
        return distances(from, ClosestPoints(mesh));
      },
      py::arg("points"), py::arg("V"), py::arg("F"),
      "Distances of points from a surface, mm, one a point.");
  module.def(
      "closest_points",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F) {
        const std::vector<ClosestPoint> found = closest_points(points, V, F);
        Points3 out(static_cast<Eigen::Index>(found.size()), 3);
        for (Eigen::Index k = 0; k < out.rows(); ++k) out.row(k) = found[k].point;
        return out;
      },
      py::arg("points"), py::arg("V"), py::arg("F"),
      "The nearest points of a surface, one a point.");
  module.def(
      "closest_faces",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F) {
        std::vector<int> out;
        for (const ClosestPoint& one : closest_points(points, V, F)) out.push_back(one.face);
        return py::array_t<int>(py::cast(out));
      },
      py::arg("points"), py::arg("V"), py::arg("F"),
      "The faces (rows of F) on which the nearest points of a surface lie, one a point.");
  py::class_<Registration>(module, "Registration", "x -> R x + t lays a scanned point.")
      .def_property_readonly("R", [](const Registration& r) { return r.pose.R; })
      .def_property_readonly("t", [](const Registration& r) { return r.pose.t; })
      .def_readonly("noise", &Registration::noise)
      .def_readonly("loss_scale", &Registration::loss_scale)
      .def_readonly("rotation_deviation", &Registration::rotation_deviation)
      .def_readonly("translation_deviation", &Registration::translation_deviation)
      .def_readonly("other_turns", &Registration::other_turns);
  module.def(
      "register_scan",
      [](const PointsIn& points, const PointsIn& V, const TrianglesIn& F, double tile,
         py::object progress) {
        const Points3 from = read_points(points, "points");
        const TriangleMesh mesh = read_mesh(V, F);
        require_positive(tile, "tile");
        return without_gil(std::move(progress),
                           [&](const Progress&) { return register_scan(from, mesh, tile); });
      },
      py::arg("points"), py::arg("V"), py::arg("F"), py::arg("tile"),
      py::arg("progress") = py::none(),
      "Lays scanned points onto a surface of tiles so large, mm.");
  module.def(
      "register_markers",
      [](const PointsIn& points, const PointsIn& targets) {
        const Points3 from = read_points(points, "points"), to = read_points(targets, "targets");
        if (from.rows() != to.rows()) {
          throw InvalidInput("there are not as many targets as points", "give one a point");
        }
        const py::gil_scoped_release release;
        return register_markers(from, to);
      },
      py::arg("points"), py::arg("targets"), "Lays points onto targets, one a point.");
  module.def(
      "surface_deviation",
      [](const PointsIn& V, const TrianglesIn& F, const PointsIn& target_V,
         const TrianglesIn& target_F, py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const TriangleMesh target = read_mesh(target_V, target_F, "target_V", "target_F");
        const Deviation d = without_gil(std::move(progress), [&](const Progress&) {
          checkpoint("measuring deviation");
          return surface_deviation(mesh, target);
        });
        return std::array<double, 4>{d.mean, d.rms, d.max, d.hausdorff};
      },
      py::arg("V"), py::arg("F"), py::arg("target_V"), py::arg("target_F"),
      py::arg("progress") = py::none(),
      "Mean, RMS and largest distance from the target, and the Hausdorff distance, mm.");
  module.def(
      "shortest_edge_path",
      [](const PointsIn& V, const TrianglesIn& F, const PointsIn& points) {
        return shortest_edge_path(read_mesh(V, F), read_points(points, "points"));
      },
      py::arg("V"), py::arg("F"), py::arg("points"),
      "Vertices of the shortest edge path through those nearest to the points.");
  module.def(
      "conformal_map",
      [](const PointsIn& V, const TrianglesIn& F) {
        const TriangleMesh mesh = read_mesh(V, F);
        const py::gil_scoped_release release;
        return conformal_map(mesh);
      },
      py::arg("V"), py::arg("F"), "Flat positions of the vertices (spectral conformal map).");
  module.def(
      "triangulate_polygon",
      [](const PointsIn& points) { return triangulate_polygon(read_points(points, "points")); },
      py::arg("points"),
      "Triangles, as rows of points, of a plane polygon of any shape; none where it crosses "
      "itself.");

  py::class_<CleanMesh>(module, "CleanMesh", "A repaired mesh and what was done to it.")
      .def_property_readonly("V", [](const CleanMesh& c) { return c.mesh.V; })
      .def_property_readonly("F", [](const CleanMesh& c) { return c.mesh.F; })
      .def_readonly("notes", &CleanMesh::notes);
  module.def(
      "clean_mesh",
      [](const PointsIn& V, const TrianglesIn& F, py::object progress) {
        const TriangleMesh soup = read_unchecked_mesh(V, F);
        return without_gil(std::move(progress), [&](const Progress&) { return clean_mesh(soup); });
      },
      py::arg("V"), py::arg("F"), py::arg("progress") = py::none(),
      "Merges vertices, removes degenerate and doubled faces, makes the orientation consistent.");

  module.def(
      "check_mesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, bool cuts_given, py::object progress,
         bool without_crossings) {
        require_positive(L, "L");
        const TriangleMesh mesh = read_unchecked_mesh(V, F);
        return without_gil(std::move(progress), [&](const Progress&) {
          return check_mesh(mesh, L, cuts_given, without_crossings);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("cuts_given") = false,
      py::arg("progress") = py::none(), py::arg("without_crossings") = false,
      "What can't be made from the surface: a list of Finding. without_crossings: no face is "
      "known to run through another, which is then not looked for.");

  py::class_<MendedMesh>(module, "MendedMesh", "A mesh that can be remeshed, and what was done.")
      .def_property_readonly("V", [](const MendedMesh& m) { return m.mesh.V; })
      .def_property_readonly("F", [](const MendedMesh& m) { return m.mesh.F; })
      .def_readonly("actions", &MendedMesh::actions)
      .def_readonly("without_crossings", &MendedMesh::without_crossings);
  module.def(
      "mend_mesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, double hole_edge, py::object progress) {
        const TriangleMesh mesh = read_unchecked_mesh(V, F);
        return without_gil(std::move(progress), [&](const Progress&) {
          return mend_mesh(mesh, {L, hole_edge});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("hole_edge"),
      py::arg("progress") = py::none(),
      "Takes non-manifold parts apart, removes crumbs and small intersections, fills holes whose "
      "edge is shorter than hole_edge mm.");

  py::class_<RemeshResult>(module, "RemeshResult", "A uniform triangulation and its figures.")
      .def_property_readonly("V", [](const RemeshResult& r) { return r.mesh.V; })
      .def_property_readonly("F", [](const RemeshResult& r) { return r.mesh.F; })
      .def_readonly("mean_edge", &RemeshResult::mean_edge)
      .def_readonly("edge_cv", &RemeshResult::edge_cv)
      .def_readonly("chord_error", &RemeshResult::chord_error)
      .def_readonly("features", &RemeshResult::features);

  module.def(
      "remesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, py::object progress,
         double crease_angle, const EdgesIn& features, double corner_reach) {
        constexpr double degree = 3.14159265358979323846 / 180;
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges lines = read_edges(features, mesh.V.rows(), "features");
        return without_gil(std::move(progress), [&](const Progress&) {
          return remesh(mesh, {L, crease_angle * degree, lines, corner_reach});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("progress") = py::none(),
      py::arg("crease_angle") = 180.0, py::arg("features") = Edges(0, 2),
      py::arg("corner_reach") = 0.0,
      "Uniform isotropic triangulation of mean edge length L mm; creases above crease_angle "
      "(degrees) and features (vertex pairs) stay edges; corners of the boundary are looked at "
      "from "
      "corner_reach mm away.");

  py::class_<SurfaceDivision>(module, "SurfaceDivision", "A surface in pieces that can lie flat.")
      .def_property_readonly("piece",
                             [](const SurfaceDivision& d) { return py::array(py::cast(d.piece)); })
      .def_readonly("borders", &SurfaceDivision::borders)
      .def_readonly("slits", &SurfaceDivision::slits);
  module.def(
      "divide_surface",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts, int count,
         py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        return without_gil(std::move(progress), [&](const Progress&) {
          checkpoint("dividing into pieces");
          const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
          return divide_surface(mesh, topology, mark_cuts(topology, edges), count);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("count"),
      py::arg("progress") = py::none(),
      "Divides a mesh that is cut along `cuts` into `count` pieces: the piece of each face, the "
      "edges "
      "between pieces, and the slits inside of them that let each lie flat.");
  module.def(
      "pieces_of_faces",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
        return py::array(py::cast(pieces_of_faces(topology, mark_cuts(topology, edges))));
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"),
      "The piece of each face of a mesh that is cut along `cuts`, from 0 in the order of the "
      "lowest faces.");
}

}  // namespace curveups::bindings
