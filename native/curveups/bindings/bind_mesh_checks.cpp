// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/mesh_checks.hpp"

namespace curveups::bindings {

void bind_mesh_checks(py::module_& module) {
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
      "What can't be made from the surface: a list of MeshFinding. without_crossings: no face is "
      "known to run through another, which is then not looked for.");
}

}  // namespace curveups::bindings
