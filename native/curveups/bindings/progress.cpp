// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

namespace curveups::bindings {
namespace {

// What a sink answers counts as Python counts truth, and nothing as yes.
bool goes_on(const py::object& answer) { return answer.is_none() || py::bool_(answer); }

}  // namespace

PythonProgress::PythonProgress(py::object callable) : callable_(std::move(callable)) {}

Progress PythonProgress::function() {
  return [this](const std::string& what, double fraction) {
    py::gil_scoped_acquire acquire;
    if (error_) return false;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (callable_.is_none()) return true;
      const py::object answer = callable_(what, fraction);
      return goes_on(answer);
    } catch (...) {
      error_ = std::current_exception();
      return false;
    }
  };
}

void PythonProgress::rethrow() {
  if (error_) std::rethrow_exception(error_);
}

PythonListener::Function PythonListener::function() {
  if (callable_.is_none()) return {};
  return [this](const Array6& T, const Array6& q, double figure, double violation) {
    py::gil_scoped_acquire acquire;
    try {
      const py::object answer =
          callable_(to_blocks(T, 3, 2), to_blocks(q, 2, 3), figure, violation);
      return goes_on(answer);
    } catch (...) {
      error_ = std::current_exception();
      return false;
    }
  };
}

void PythonListener::rethrow() {
  if (error_) std::rethrow_exception(error_);
}

}  // namespace curveups::bindings
