// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces and the shape that a piece has once its tiles have settled.
#include "curveups/bindings/bindings.hpp"
#include "curveups/bindings/scan_block.hpp"
#include "curveups/contact/settled_design.hpp"

namespace curveups::bindings {
namespace {

// As report.json has it.
py::dict block(const SettledDesign& settled) {
  py::dict out;
  out["friction_coefficient"] = settled.friction_coefficient;
  out["hold_tolerance_mm"] = settled.hold_tolerance;
  out["converged"] = settled.converged;
  out["normal_mean"] = settled.normal_mean;
  out["normal_min"] = settled.normal_min;
  out["open_contacts"] = settled.open_contacts;
  out["element_change"] = settled.element_change;
  out["largest_slip_mm"] = settled.largest_slip;
  out["drift_mm"] = settled.drift;
  out["holding_friction"] =
      settled.holding_friction ? py::cast(*settled.holding_friction) : py::none();
  out["scan"] = scan_block(settled.scan);
  return out;
}

}  // namespace

void bind_settled(py::module_& module) {
  py::class_<WindowEnd>(module, "WindowEnd", "The last sample that holds.")
      .def_readonly("value", &WindowEnd::value)
      .def_readonly("failure", &WindowEnd::failure,
                    "What fails at the next sample; None where nothing does.");
  py::class_<WindowRange>(module, "WindowRange", "The range of a parameter in which it holds.")
      .def_readonly("parameter", &WindowRange::parameter)
      .def_readonly("unit", &WindowRange::unit)
      .def_readonly("searched", &WindowRange::searched)
      .def_property_readonly("low", [](const WindowRange& range) { return range.end[0]; })
      .def_property_readonly("high", [](const WindowRange& range) { return range.end[1]; });
  py::class_<Margin>(module, "Margin",
                     "Whether pushing forces within friction exist at the corners of the margin.")
      .def_readonly("mode", &Margin::mode)
      .def_readonly("mismatch", &Margin::mismatch, "Of the membranes' pull, %.")
      .def_readonly("friction_coefficient", &Margin::friction_coefficient)
      .def_readonly("met", &Margin::met)
      .def_property_readonly(
          "failures",
          [](const Margin& margin) {
            return std::vector<std::optional<Finding>>(margin.failure.begin(),
                                                       margin.failure.end());
          },
          "What fails where the front pulls harder, and the back.");
  py::class_<FrictionNeeded>(module, "FrictionNeeded",
                             "Least coefficient at which forces in balance exist.")
      .def_readonly("coefficient", &FrictionNeeded::coefficient, "None where it is not known.")
      .def_readonly("tiles", &FrictionNeeded::tiles, "Tiles that need most.");
  py::class_<SettledDesign>(module, "SettledDesign",
                            "What develops where a design's tiles are let go when actuated.")
      .def_readonly("holds", &SettledDesign::holds, "None where that is not known.")
      .def_readonly("failure", &SettledDesign::failure, "Why it does not hold.")
      .def_property_readonly("block", &block, "The figures, as report.json has them.")
      .def_readonly("margin", &SettledDesign::margin)
      .def_readonly("friction_needed", &SettledDesign::friction_needed)
      .def_readonly("window", &SettledDesign::window)
      .def_readonly("contact_force", &SettledDesign::contact_force,
                    "Normal force of each contact, N.")
      .def_readonly(
          "corners", &SettledDesign::corners,
          "Settled front corners of the tiles, three rows a tile, fitted to the design, mm.")
      .def_readonly("deviation", &SettledDesign::deviation,
                    "Mean distance of each tile from the design's surface, mm.")
      .def_readonly(
          "poses", &SettledDesign::poses,
          "A row a tile, how far its centre has moved (mm) and the quaternion (x, y, z, w) "
          "that it has turned by.")
      .def_readonly("iterations", &SettledDesign::iterations);
  module.def(
      "settle_design",
      [](const Design& design, py::object progress, const SolvedPtr& solved) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return settle_design(design, sink, solved);
        });
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("solved") = py::none(),
      "Lets the tiles of a design settle from where they stand when actuated, under its "
      "parameters. solved: VerificationReport.solved of the same tiles, pins and membranes.");
}

}  // namespace curveups::bindings
