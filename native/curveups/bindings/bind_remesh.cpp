// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/remesh.hpp"

namespace curveups::bindings {

void bind_remesh(py::module_& module) {
  py::class_<RemeshResult>(module, "RemeshResult", "A uniform triangulation and its figures.")
      .def_property_readonly("V", [](const RemeshResult& r) { return r.mesh.V; })
      .def_property_readonly("F", [](const RemeshResult& r) { return r.mesh.F; })
      .def_readonly("mean_edge", &RemeshResult::mean_edge)
      .def_readonly("edge_cv", &RemeshResult::edge_cv)
      .def_readonly("max_distance", &RemeshResult::max_distance)
      .def_readonly("sagitta", &RemeshResult::sagitta)
      .def_readonly("features", &RemeshResult::features);

  module.def(
      "remesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, py::object progress,
         double crease_angle, const EdgesIn& features, double corner_reach) {
        constexpr double degree = 3.14159265358979323846 / 180;
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges lines = read_edges(features, mesh.V.rows(), "features");
        return without_gil(std::move(progress), [&](Progress function) {
          return remesh(mesh, {L, std::move(function), crease_angle * degree, lines, corner_reach});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("progress") = py::none(),
      py::arg("crease_angle") = 180.0, py::arg("features") = Edges(0, 2),
      py::arg("corner_reach") = 0.0,
      "Uniform isotropic triangulation of mean edge length L mm; creases above crease_angle "
      "(degrees) and features (vertex pairs) stay edges; corners of the boundary are looked at "
      "from "
      "corner_reach mm away.");
}

}  // namespace curveups::bindings
