// SPDX-License-Identifier: LGPL-2.1-or-later
// One function for each group of bindings, in a file of its name; module.cpp calls them in the
// order of dependency.
//
// Arrays go in through arrays.hpp, which checks them, and come out as numpy arrays. Results are
// classes with read-only attributes. Long calls release the GIL and take progress=None, a callable
// (what: str, fraction: float) -> bool; its exceptions (KeyboardInterrupt above all) end the call.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/types.hpp"

namespace curveups {
struct SolvedDesign;
}  // namespace curveups

namespace curveups::bindings {

namespace py = pybind11;

// Python holds what native code shares as const.
using SolvedPtr = std::shared_ptr<SolvedDesign>;

// For calls of native code, whose arguments need no GIL: progress sinks acquire it.
using Released = py::call_guard<py::gil_scoped_release>;
// Called with the iterates of long work: flat corners (M x 3 x 2), insets (M x 2 x 3), a figure of
// the work, the largest violation of constraints. Stops the work by returning false.
using Listener = std::function<bool(py::array_t<double>, py::array_t<double>, double, double)>;
// The same for native code, with the GIL released; empty without a listener, which it refers to.
std::function<bool(const Array6& T, const Array6& q, double figure, double violation)>
native_listener(const std::optional<Listener>& listener);

// The `block` of an object or of each item of a list; anything else as it is.
py::object to_block(const py::object& value);

// A class of figures. Each is listed once, by its name in report.json and a member or a function of
// the struct: it becomes a read-only attribute, and all of them in this order the dict `block`.
template <class T, class... Holder>
class FiguresClass : public py::class_<T, Holder...> {
 public:
  FiguresClass(const py::handle& scope, const char* name, const char* doc)
      : py::class_<T, Holder...>(scope, name, doc) {
    this->def_property_readonly(
        "block",
        [names = names_](const py::object& self) {
          py::dict out;
          for (const py::handle& key : names) out[key] = to_block(self.attr(key));
          return out;
        },
        "Figures by name, as report.json has them.");
  }

  template <class Get>
  FiguresClass& figure(const char* name, Get get, const char* doc = "") {
    if constexpr (std::is_member_object_pointer_v<Get>) {
      this->def_readonly(name, get, doc);
    } else {
      this->def_property_readonly(name, get, doc);
    }
    names_.append(name);
    return *this;
  }

 private:
  py::list names_;
};

// Rows as blocks of this shape.
template <class Matrix>
py::array_t<double> to_blocks(const Matrix& rows, std::vector<py::ssize_t> shape) {
  shape.insert(shape.begin(), rows.rows());
  return py::array_t<double>(shape, rows.data());
}

void bind_errors(py::module_& module);
void bind_parameters(py::module_& module);
void bind_meshes(py::module_& module);
void bind_design(py::module_& module);
void bind_targets(py::module_& module);
void bind_layout(py::module_& module);
void bind_verification(py::module_& module);
void bind_settled(py::module_& module);
void bind_actuation(py::module_& module);
void bind_print_model(py::module_& module);

}  // namespace curveups::bindings
