// SPDX-License-Identifier: LGPL-2.1-or-later
// Targets, mesh repair and checks, remeshing.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "curveups/bindings/bindings.hpp"
#include "curveups/geometry/builtin_targets.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/conformal_map.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "curveups/geometry/mesh_checks.hpp"
#include "curveups/geometry/remesh.hpp"

namespace curveups::bindings {
namespace {

// The geometry room takes a mesh as one value, Python as two arrays.
TriangleMesh joined(const Points3& V, const Triangles& F) { return {V, F}; }

}  // namespace

void bind_geometry(py::module_& module) {
  py::class_<CleanMesh>(module, "CleanMesh", "A repaired mesh and what was done to it.")
      .def_property_readonly("V", [](const CleanMesh& c) { return c.mesh.V; })
      .def_property_readonly("F", [](const CleanMesh& c) { return c.mesh.F; })
      .def_readonly("notes", &CleanMesh::notes);
  py::class_<MeshFinding>(module, "MeshFinding", "What is wrong with a surface, and where.")
      .def_readonly("kind", &MeshFinding::kind)
      .def_readonly("message", &MeshFinding::message)
      .def_readonly("remedy", &MeshFinding::remedy)
      .def_readonly("faces", &MeshFinding::faces)
      .def_readonly("vertices", &MeshFinding::vertices)
      .def_readonly("is_error", &MeshFinding::is_error)
      .def("__repr__", [](const MeshFinding& f) {
        return "<MeshFinding " + f.kind + (f.is_error ? " (error): " : ": ") + f.message + ">";
      });
  py::class_<RemeshResult>(module, "RemeshResult", "A uniform triangulation and its figures.")
      .def_property_readonly("V", [](const RemeshResult& r) { return r.mesh.V; })
      .def_property_readonly("F", [](const RemeshResult& r) { return r.mesh.F; })
      .def_readonly("mean_edge", &RemeshResult::mean_edge)
      .def_readonly("edge_cv", &RemeshResult::edge_cv)
      .def_readonly("max_distance", &RemeshResult::max_distance)
      .def_readonly("sagitta", &RemeshResult::sagitta);

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
      "clean_mesh",
      [](const Points3& V, const Triangles& F) {
        const py::gil_scoped_release release;
        return clean_mesh(joined(V, F));
      },
      py::arg("V"), py::arg("F"),
      "Merges vertices, removes degenerate and doubled faces, makes the orientation consistent.");
  module.def(
      "check_mesh",
      [](const Points3& V, const Triangles& F, double L, bool cuts_given) {
        const py::gil_scoped_release release;
        return check_mesh(joined(V, F), L, cuts_given);
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("cuts_given") = false,
      "What can't be made from the surface: a list of MeshFinding.");
  module.def(
      "remesh",
      [](const Points3& V, const Triangles& F, double L, py::object progress) {
        return without_gil(std::move(progress), [&](Progress function) {
          return remesh(joined(V, F), RemeshOptions{L, std::move(function)});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("progress") = py::none(),
      "Uniform isotropic triangulation of mean edge L mm.");
  module.def(
      "mean_edge_length",
      [](const Points3& V, const Triangles& F) { return mean_edge_length(joined(V, F)); },
      py::arg("V"), py::arg("F"), "Mean length of the edges, mm.");
  module.def(
      "surface_deviation",
      [](const Points3& V, const Triangles& F, const Points3& target_V, const Triangles& target_F) {
        const py::gil_scoped_release release;
        const Deviation d = surface_deviation(joined(V, F), joined(target_V, target_F));
        return std::array<double, 3>{d.mean, d.max, d.hausdorff};
      },
      py::arg("V"), py::arg("F"), py::arg("target_V"), py::arg("target_F"),
      "Mean and largest distance from the target, and the Hausdorff distance, mm.");
  module.def(
      "shortest_edge_path",
      [](const Points3& V, const Triangles& F, const Points3& points) {
        return shortest_edge_path(joined(V, F), points);
      },
      py::arg("V"), py::arg("F"), py::arg("points"),
      "Vertices of the shortest edge path through those nearest to the points.");
  module.def(
      "conformal_map",
      [](const Points3& V, const Triangles& F) {
        const py::gil_scoped_release release;
        return conformal_map(joined(V, F));
      },
      py::arg("V"), py::arg("F"), "Flat positions of the vertices (spectral conformal map).");
}

}  // namespace curveups::bindings
