// SPDX-License-Identifier: LGPL-2.1-or-later
// One function for what belongs together, in a file of its name; module.cpp calls them in the order
// of dependency.
//
// Style: arrays go in as arrays.hpp says, which checks them, and out as numpy arrays; results are
// small classes with read-only attributes; long calls take progress=None, a callable (what: str,
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
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/core/types.hpp"

namespace curveups {
struct SolvedDesign;
}

namespace curveups::bindings {

namespace py = pybind11;

// Python holds what native code shares as const.
using SolvedPtr = std::shared_ptr<SolvedDesign>;

// Wraps a Python callable (or None) so that it can be called with the GIL released. What it raises
// (KeyboardInterrupt above all) is kept and raised again when the native call has returned.
class PythonProgress {
 public:
  explicit PythonProgress(py::object callable);
  Progress function();
  // To be called with the GIL held after the native work: raises what the callable raised.
  void rethrow();

 private:
  py::object callable_;
  std::exception_ptr error_;
};

// Runs work(progress) with the GIL released; checkpoints within it ask the callable as well.
template <class Work>
auto without_gil(py::object callable, Work work) {
  PythonProgress progress(std::move(callable));
  try {
    auto result = [&] {
      const py::gil_scoped_release release;
      const ProgressScope scope(progress.function());
      return work(scope.sink());
    }();
    progress.rethrow();
    return result;
  } catch (const Cancelled&) {
    progress.rethrow();
    throw;
  }
}

// A Python callable (or None) that gets the iterates of long work as (T, q, figure), the same way;
// it answers whether to go on.
class PythonListener {
 public:
  using Function =
      std::function<bool(const Array6& T, const Array6& q, double figure, double violation)>;
  explicit PythonListener(py::object callable) : callable_(std::move(callable)) {}
  Function function();  // empty where there is no callable
  void rethrow();

 private:
  py::object callable_;
  std::exception_ptr error_;
};

// An M x 6 matrix as an M x a x b array, a b = 6.
py::array_t<double> to_blocks(const Array6& m, int a, int b);

void bind_errors(py::module_& module);
void bind_findings(py::module_& module);
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
