// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"

PYBIND11_MODULE(_native, module) {
  using namespace curveups::bindings;
  module.doc() = "Native part of CurveUps: layout, truncation, contacts and tile solids.";
  module.attr("__version__") = CURVEUPS_VERSION;
  bind_errors(module);
  bind_threads(module);
  bind_geometry(module);
  bind_clean_mesh(module);
  bind_mesh_checks(module);
  bind_mend_mesh(module);
  bind_remesh(module);
  bind_divide_surface(module);
  bind_parameters(module);
  bind_design(module);
  bind_design_figures(module);
  bind_target_checks(module);
  bind_tile_shapes(module);
  bind_layout(module);
  bind_layout_figures(module);
  bind_fields(module);
  bind_cut_suggestions(module);
  bind_remedies(module);
  bind_solution_store(module);
  bind_verification(module);
  bind_repair(module);
  bind_pin_relief(module);
  bind_fairing(module);
  bind_print_model(module);
}
