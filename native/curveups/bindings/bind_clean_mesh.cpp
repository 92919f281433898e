// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/clean_mesh.hpp"

namespace curveups::bindings {

void bind_clean_mesh(py::module_& module) {
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
}

}  // namespace curveups::bindings
