// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups::bindings {

void bind_threads(py::module_& module) {
  module.def("thread_count", &thread_count, "Threads that parallel loops use.");
  module.def("set_thread_count", &set_thread_count, py::arg("count"),
             "Sets the number of threads; results do not depend on it.");
}

}  // namespace curveups::bindings
