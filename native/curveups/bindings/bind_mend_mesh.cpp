// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/mend_mesh.hpp"

namespace curveups::bindings {

void bind_mend_mesh(py::module_& module) {
  py::class_<MendedMesh>(module, "MendedMesh", "A mesh that can be remeshed, and what was done.")
      .def_property_readonly("V", [](const MendedMesh& m) { return m.mesh.V; })
      .def_property_readonly("F", [](const MendedMesh& m) { return m.mesh.F; })
      .def_readonly("actions", &MendedMesh::actions)
      .def_readonly("without_crossings", &MendedMesh::without_crossings);
  module.def(
      "mend_mesh",
      [](const PointsIn& V, const TrianglesIn& F, double L, double hole_edge, py::object progress) {
        const TriangleMesh mesh = read_unchecked_mesh(V, F);
        return without_gil(std::move(progress), [&](Progress function) {
          return mend_mesh(mesh, {L, hole_edge, std::move(function)});
        });
      },
      py::arg("V"), py::arg("F"), py::arg("L"), py::arg("hole_edge"),
      py::arg("progress") = py::none(),
      "Takes non-manifold parts apart, removes crumbs and small intersections, fills holes whose "
      "edge is shorter than hole_edge mm.");
}

}  // namespace curveups::bindings
