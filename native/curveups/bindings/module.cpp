// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

PYBIND11_MODULE(_native, module) {
  using namespace curveups::bindings;
  module.doc() = "Native part of CurveUps: layout, truncation, contacts and tile solids.";
  module.attr("__version__") = CURVEUPS_VERSION;
  bind_core(module);
  bind_geometry(module);
  bind_design(module);
  bind_layout(module);
  bind_cuts(module);
  bind_physics(module);
  bind_refinement(module);
  bind_print_model(module);
}
