// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

namespace curveups::bindings {

// A callable that returns None goes on.
template <class Call>
bool PythonCallback::guarded(const Call& call) {
  const py::gil_scoped_acquire acquire;
  if (error_) return false;
  try {
    const py::object answer = call();
    return answer.is_none() || py::bool_(answer);
  } catch (...) {
    error_ = std::current_exception();
    return false;
  }
}

Progress PythonCallback::progress() {
  return [this](const std::string& what, double fraction) {
    return guarded([&]() -> py::object {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return callable_.is_none() ? callable_ : callable_(what, fraction);
    });
  };
}

std::function<bool(const Array6&, const Array6&, double, double)> PythonCallback::listener() {
  if (callable_.is_none()) return {};
  return [this](const Array6& T, const Array6& q, double figure, double violation) {
    return guarded(
        [&] { return callable_(to_blocks(T, 3, 2), to_blocks(q, 2, 3), figure, violation); });
  };
}

py::object to_block(const py::object& value) {
  if (py::hasattr(value, "block")) return value.attr("block");
  if (!py::isinstance<py::list>(value)) return value;
  py::list out;
  for (const py::handle& item : value)
    out.append(to_block(py::reinterpret_borrow<py::object>(item)));
  return out;
}

}  // namespace curveups::bindings
