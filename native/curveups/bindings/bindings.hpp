// SPDX-License-Identifier: LGPL-2.1-or-later
// One function for each group of bindings, in a file of its name; module.cpp calls them in the
// order of dependency.
//
// Arrays go in through arrays.hpp, which checks them, and come out as numpy arrays. Results are
// classes with read-only attributes. Long calls take progress=None, a callable (what: str,
// fraction: float) -> bool, and release the GIL.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/types.hpp"

namespace curveups {
enum class Side;
struct SolvedDesign;
}  // namespace curveups

namespace curveups::bindings {

namespace py = pybind11;

// Python holds what native code shares as const.
using SolvedPtr = std::shared_ptr<SolvedDesign>;

// A Python callable (or None) that native code calls without the GIL. An exception of the callable
// (KeyboardInterrupt above all) stops the work and is raised once the work has returned.
class PythonCallback {
 public:
  explicit PythonCallback(py::object callable) : callable_(std::move(callable)) {}
  // As progress sink. Looks for signals too.
  Progress progress();
  // As listener of iterates: flat corners, insets, a figure of the work, the largest violation of
  // constraints. Empty for None.
  std::function<bool(const Array6& T, const Array6& q, double figure, double violation)> listener();
  // Needs the GIL.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  template <class Call>
  bool guarded(const Call& call);

  py::object callable_;
  std::exception_ptr error_;
};

// Runs work(progress) with the GIL released; checkpoints within it ask the callable as well.
template <class Work>
auto without_gil(py::object callable, Work work) {
  PythonCallback progress(std::move(callable));
  try {
    auto result = [&] {
      const py::gil_scoped_release release;
      const ProgressScope scope(progress.progress());
      return work(scope.sink());
    }();
    progress.rethrow();
    return result;
  } catch (const Cancelled&) {
    progress.rethrow();
    throw;
  }
}

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

// "front" or "back".
const char* side_name(Side side);
// An M x 6 matrix as an M x a x b array, a b = 6.
py::array_t<double> to_blocks(const Array6& m, int a, int b);

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
