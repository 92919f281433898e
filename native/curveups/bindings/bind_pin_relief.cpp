// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/refinement/pin_relief.hpp"

namespace curveups::bindings {

void bind_pin_relief(py::module_& module) {
  py::class_<SmallPin>(module, "SmallPin", "A pin side whose bounds leave less than A_pin_min.")
      .def_readonly("tile", &SmallPin::tile)
      .def_property_readonly(
          "side", [](const SmallPin& p) { return p.side == Side::front ? "front" : "back"; })
      .def_readonly("area", &SmallPin::area, "mm2");
  py::class_<PinRelief>(module, "PinRelief", "Vertices moved so that pins have room.")
      .def_property_readonly("V", [](const PinRelief& r) { return r.mesh.V; })
      .def_readonly("largest_move_mm", &PinRelief::largest_move)
      .def_readonly("relieved", &PinRelief::relieved)
      .def_readonly("remaining", &PinRelief::remaining);
  module.def(
      "relieve_pins",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts, const Parameters& parameters,
         py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return relieve_pins(mesh, edges, parameters, sink);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(),
      "Moves vertices a little where folds leave pin sides less than A_pin_min.");
}

}  // namespace curveups::bindings
