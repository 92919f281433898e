// SPDX-License-Identifier: LGPL-2.1-or-later
// What speaks for or against a surface, a design or its bodies.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/finding.hpp"

namespace curveups::bindings {

void bind_findings(py::module_& module) {
  py::class_<Finding>(
      module, "Finding",
      "What speaks for or against something; base/findings.py makes sentences of it.")
      .def_readonly("kind", &Finding::kind)
      .def_readonly("tiles", &Finding::tiles, "That it is about, ascending; none: all of them.")
      .def_readonly("figures", &Finding::figures, "That its sentence names, by name.")
      .def_readonly("is_error", &Finding::is_error, "Nothing can be made of a surface like this.")
      .def("__repr__", [](const Finding& found) {
        return "<Finding " + found.kind + (found.is_error ? " (error)>" : ">");
      });
}

}  // namespace curveups::bindings
