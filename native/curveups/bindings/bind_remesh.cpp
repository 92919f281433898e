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
      .def_readonly("sagitta", &RemeshResult::sagitta);

  module.def(
      "remesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        return without_gil(std::move(progress), [&](Progress function) {
          return remesh(mesh, RemeshOptions{L, std::move(function)});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("progress") = py::none(),
      "Uniform isotropic triangulation of mean edge L mm.");
}

}  // namespace curveups::bindings
