// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks of a remeshed target.
#include "curveups/bindings/bindings.hpp"
#include "curveups/design/target_checks.hpp"

namespace curveups::bindings {

void bind_target_checks(py::module_& module) {
  py::class_<TargetFinding>(
      module, "TargetFinding",
      "What can't work on a target, or may not: kind, message, remedy, tiles.")
      .def_readonly("kind", &TargetFinding::kind)
      .def_readonly("message", &TargetFinding::message)
      .def_readonly("remedy", &TargetFinding::remedy)
      .def_readonly("tiles", &TargetFinding::tiles)
      .def_readonly("is_error", &TargetFinding::is_error);
  module.def(
      "check_target",
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters) {
        py::gil_scoped_release release;
        return check_target({V, F}, cuts, parameters);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      "What tiles of this thickness and these pins can't do on a remeshed target.");
}

}  // namespace curveups::bindings
