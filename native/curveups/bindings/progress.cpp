// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

namespace curveups::bindings {

std::function<bool(const Array6&, const Array6&, double, double)> native_listener(
    const std::optional<Listener>& listener) {
  if (!listener) return {};
  return [&call = *listener](const Array6& T, const Array6& q, double figure, double violation) {
    const py::gil_scoped_acquire acquire;
    return call(to_blocks(T, {3, 2}), to_blocks(q, {2, 3}), figure, violation);
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
