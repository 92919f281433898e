// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/parallel.hpp"

PYBIND11_MODULE(_native, module) {
  using namespace curveups::bindings;
  module.doc() = "Native part of CurveUps: layout, truncation, contacts and tile solids.";
  module.attr("__version__") = CURVEUPS_VERSION;
  bind_errors(module);
  module.def("thread_count", &curveups::thread_count, "Threads that parallel loops use.");
  module.def("set_thread_count", &curveups::set_thread_count, py::arg("count"),
             "Sets the number of threads; results do not depend on it.");
  bind_parameters(module);
  bind_meshes(module);
  bind_design(module);
  bind_targets(module);
  bind_layout(module);
  bind_verification(module);
  bind_settled(module);
  bind_actuation(module);
  bind_print_model(module);
}
