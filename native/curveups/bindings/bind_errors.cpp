// SPDX-License-Identifier: LGPL-2.1-or-later
// The exceptions, each a Python class of its C++ name with the attributes `remedy` and `tiles`, and
// findings.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/finding.hpp"

namespace curveups::bindings {
namespace {

// pybind11 asks the translator that was registered last first: bases come before derived classes.
template <class E>
py::handle bind_error(py::module_& module, const char* name, const char* doc,
                      const py::handle& base) {
  // Never destroyed: translators run until the interpreter ends.
  static const py::handle type = py::exception<E>(module, name, base).release();
  type.attr("__doc__") = doc;
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is pybind11's
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const E& error) {
      const py::object instance = type(error.what());
      instance.attr("remedy") = error.remedy();
      instance.attr("tiles") = error.tiles();
      PyErr_SetObject(type.ptr(), instance.ptr());
    }
  });
  return type;
}

}  // namespace

void bind_errors(py::module_& module) {
  const py::handle error =
      bind_error<Error>(module, "Error", "Base of this module's exceptions.", PyExc_RuntimeError);
  error.attr("remedy") = "";
  error.attr("tiles") = py::tuple();
  bind_error<InvalidInput>(module, "InvalidInput", "A value, file or array breaks its contract.",
                           error);
  bind_error<TopologyError>(module, "TopologyError", "The surface is no oriented manifold.", error);
  bind_error<InfeasibleDesign>(module, "InfeasibleDesign",
                               "No tiles, pins or solids like this exist.", error);
  bind_error<SolverFailure>(module, "SolverFailure", "A numerical method broke down.", error);
  bind_error<IoError>(module, "IoError", "A file could not be read or written.", error);
  bind_error<Cancelled>(module, "Cancelled", "Stopped by the caller, without a partial result.",
                        error);

  py::class_<Finding>(module, "Finding",
                      "A reason, warning or advice; base/sentences.py makes sentences of it.")
      .def_readonly("kind", &Finding::kind)
      .def_readonly("tiles", &Finding::tiles, "Tiles concerned, ascending; empty: all of them.")
      .def_readonly("figures", &Finding::figures, "Figures of its sentence, by name.")
      .def_readonly("is_error", &Finding::is_error, "Nothing can be made of a surface like this.");
}

}  // namespace curveups::bindings
