// SPDX-License-Identifier: LGPL-2.1-or-later
// The exceptions, each a Python class of its C++ name.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/errors.hpp"

namespace curveups::bindings {
namespace {

// A Python class per C++ exception, with the attributes `remedy` and `tiles`.
template <class E>
void raise(const py::handle& type, const E& error) {
  py::object instance = type(error.what());
  instance.attr("remedy") = error.remedy();
  instance.attr("tiles") = error.tiles();
  PyErr_SetObject(type.ptr(), instance.ptr());
}

py::object make_exception(py::module_& module, const char* name, const char* doc,
                          const py::handle& base) {
  const std::string full = "curveups._native." + std::string(name);
  py::object type = py::reinterpret_steal<py::object>(
      PyErr_NewExceptionWithDoc(full.c_str(), doc, base.ptr(), nullptr));
  if (!type) throw py::error_already_set();
  module.attr(name) = type;
  return type;
}

// Leaked on purpose: translators run until the interpreter ends.
struct ErrorTypes {
  py::object error, invalid_input, topology_error, infeasible_design, solver_failure, io_error,
      cancelled;
};
ErrorTypes* types = nullptr;

}  // namespace

void bind_errors(py::module_& module) {
  types = new ErrorTypes;
  types->error =
      make_exception(module, "Error", "Base of this module's exceptions.", PyExc_RuntimeError);
  types->error.attr("remedy") = "";
  types->error.attr("tiles") = py::tuple();
  auto make = [&](const char* name, const char* doc) {
    return make_exception(module, name, doc, types->error);
  };
  types->invalid_input = make("InvalidInput", "A value, file or array breaks its contract.");
  types->topology_error = make("TopologyError", "The surface is no oriented manifold.");
  types->infeasible_design = make("InfeasibleDesign", "No tiles, pins or solids like this exist.");
  types->solver_failure = make("SolverFailure", "A numerical method broke down.");
  types->io_error = make("IoError", "A file could not be read or written.");
  types->cancelled = make("Cancelled", "Stopped by the caller, without a partial result.");
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is pybind11's
  py::register_exception_translator([](std::exception_ptr pointer) {
    if (!pointer) return;
    try {
      std::rethrow_exception(pointer);
    } catch (const InvalidInput& e) {
      raise(types->invalid_input, e);
    } catch (const TopologyError& e) {
      raise(types->topology_error, e);
    } catch (const InfeasibleDesign& e) {
      raise(types->infeasible_design, e);
    } catch (const SolverFailure& e) {
      raise(types->solver_failure, e);
    } catch (const IoError& e) {
      raise(types->io_error, e);
    } catch (const Cancelled& e) {
      raise(types->cancelled, e);
    } catch (const Error& e) {
      raise(types->error, e);
    }
  });
}

}  // namespace curveups::bindings
