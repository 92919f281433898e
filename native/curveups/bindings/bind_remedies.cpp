// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/layout/remedies.hpp"

namespace curveups::bindings {

void bind_remedies(py::module_& module) {
  py::class_<Remedies>(module, "Remedies", "Parameter values that would help weak contacts.")
      .def_readonly("H_body", &Remedies::H_body)
      .def_readonly("L", &Remedies::L)
      .def_readonly("tau", &Remedies::tau);
  module.def(
      "find_remedies",
      [](const Design& design, const std::vector<int>& pins,
         const std::vector<std::array<int, 2>>& weak) {
        require_tiles(pins, design.mesh.F.rows(), "pins");
        require_tiles(weak, design.mesh.F.rows(), "weak");
        const py::gil_scoped_release release;
        return find_remedies(design, pins, weak);
      },
      py::arg("design"), py::arg("pins"), py::arg("weak"),
      "Other values of H_body, L and tau: for pins of the tiles `pins` that want room, and "
      "contacts of the tile pairs `weak`.");
}

}  // namespace curveups::bindings
