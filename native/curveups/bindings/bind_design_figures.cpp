// SPDX-License-Identifier: LGPL-2.1-or-later
// How well a design keeps its constraints.
#include "curveups/bindings/bindings.hpp"
#include "curveups/design/target_checks.hpp"

namespace curveups::bindings {

namespace {

const char* side_name(Side side) { return side == Side::front ? "front" : "back"; }

}  // namespace

void bind_design_figures(py::module_& module) {
  py::class_<ConstraintReport>(module, "ConstraintReport")
      .def_readonly("max_rigidity_mm", &ConstraintReport::max_rigidity_mm)
      .def_readonly("max_gap_violation_mm", &ConstraintReport::max_gap_violation_mm)
      .def_readonly("max_pin_bound_violation_mm", &ConstraintReport::max_pin_bound_violation_mm)
      .def_readonly("max_pin_area_violation_mm2", &ConstraintReport::max_pin_area_violation_mm2)
      .def_readonly("close_pairs", &ConstraintReport::close_pairs)
      .def_property_readonly(
          "small_pins",
          [](const ConstraintReport& report) {
            py::list out;
            for (const SmallPin& pin : report.small_pins) {
              out.append(py::make_tuple(pin.tile, side_name(pin.side), pin.area));
            }
            return out;
          })
      .def_property_readonly(
          "relaxed",
          [](const ConstraintReport& report) {
            py::list out;
            for (const RelaxedBound& bound : report.relaxed) {
              py::dict one;
              one["what"] = bound.what;
              one["tile"] = bound.tile;
              one["side"] = side_name(bound.side);
              one["edge"] = bound.edge;
              one["from"] = bound.from;
              one["to"] = bound.to;
              out.append(one);
            }
            return out;
          },
          "Bounds of insets that gave way to folds, mm; the violation is measured against `to`.");

  py::class_<DesignFigures>(module, "DesignFigures", "Counts and areas of a design.")
      .def_readonly("contacts", &DesignFigures::contacts)
      .def_readonly("hinges", &DesignFigures::hinges)
      .def_readonly("three_point_contacts", &DesignFigures::three_point_contacts)
      .def_readonly("truncation_types", &DesignFigures::truncation_types)
      .def_readonly("unresolved", &DesignFigures::unresolved)
      .def_readonly("shortened", &DesignFigures::shortened,
                    "Pairs without a common vertex that were parted at the cost of an interface.")
      .def_readonly("flat_clearance_mm", &DesignFigures::flat_clearance,
                    "What bumps leave of d_gap_min between flat tiles.")
      .def_readonly("actuated_area_mm2", &DesignFigures::actuated_area)
      .def_readonly("flat_area_mm2", &DesignFigures::flat_area)
      .def_readonly("constraints", &DesignFigures::constraints)
      .def_readonly("reasons", &DesignFigures::reasons,
                    "Why these make a design not valid; none: they do not.");
  module.def(
      "evaluate_design",
      [](const Design& design) {
        py::gil_scoped_release release;
        return evaluate_design(design);
      },
      py::arg("design"),
      "Counts, areas and how well the hard constraints hold, from the design alone. Raises "
      "InfeasibleDesign where its tiles can't be made.");
}

}  // namespace curveups::bindings
