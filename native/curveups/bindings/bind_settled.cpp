// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces and the shape that a piece has once its tiles have settled.
#include "curveups/bindings/bindings.hpp"
#include "curveups/contact/settled_design.hpp"

namespace curveups::bindings {

void bind_settled(py::module_& module) {
  FiguresClass<VirtualScan>(module, "VirtualScan", "Distances of a surface from another.")
      .figure("mean_mm", &VirtualScan::mean)
      .figure("rms_mm", &VirtualScan::rms)
      .figure("p95_mm", &VirtualScan::p95)
      .figure("max_mm", &VirtualScan::largest)
      .figure("hausdorff_mm", &VirtualScan::hausdorff);
  py::class_<WindowEnd>(module, "WindowEnd", "The last sample that holds.")
      .def_readonly("value", &WindowEnd::value)
      .def_readonly("failure", &WindowEnd::failure, "Failure at the next sample; or None.");
  py::class_<WindowRange>(module, "WindowRange", "Range of a parameter in which a design holds.")
      .def_readonly("parameter", &WindowRange::parameter)
      .def_readonly("unit", &WindowRange::unit)
      .def_readonly("searched", &WindowRange::searched)
      .def_readonly("ends", &WindowRange::end, "Low and high.");
  FiguresClass<Margin>(module, "Margin", "Pushing forces within friction at the margin's corners.")
      .figure("mode", &Margin::mode)
      .figure("mismatch_percent", &Margin::mismatch, "Of the membranes' pull.")
      .figure("friction_coefficient", &Margin::friction_coefficient)
      .figure("met", &Margin::met)
      .def_readonly("failures", &Margin::failure,
                    "With the front pulling harder, and with the back; each may be None.");
  FiguresClass<FrictionNeeded>(module, "FrictionNeeded",
                               "Least coefficient at which forces in balance exist.")
      .figure("coefficient", &FrictionNeeded::coefficient, "None where it is not known.")
      .figure("tiles", &FrictionNeeded::tiles, "Tiles that need most.");
  using Settled = SettledDesign;
  FiguresClass<Settled>(module, "SettledDesign", "Tiles of a design at rest under friction.")
      .figure("friction_coefficient", &Settled::friction_coefficient)
      .figure("hold_tolerance_mm", &Settled::hold_tolerance)
      .figure("converged", &Settled::converged)
      .figure("normal_mean", &Settled::normal_mean)
      .figure("normal_min", &Settled::normal_min)
      .figure("open_contacts", &Settled::open_contacts)
      .figure("element_change", &Settled::element_change)
      .figure("largest_slip_mm", &Settled::largest_slip)
      .figure("drift_mm", &Settled::drift)
      .figure("holding_friction", &Settled::holding_friction)
      .figure("scan", &Settled::scan)
      .def_readonly("holds", &Settled::holds, "None where that is not known.")
      .def_readonly("failure", &Settled::failure, "Why it does not hold.")
      .def_readonly("margin", &Settled::margin)
      .def_readonly("friction_needed", &Settled::friction_needed)
      .def_readonly("window", &Settled::window)
      .def_readonly("deviation", &Settled::deviation,
                    "Mean distance of each tile from the design's surface, mm.")
      .def_readonly("iterations", &Settled::iterations);
  module.def(
      "settle_design",
      [](const Design& design, const Progress& progress, const SolvedPtr& solved) {
        return settle_design(design, ProgressScope(progress).sink(), solved);
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("solved") = py::none(),
      Released(),
      "Lets the tiles of a design settle from their actuated places, under its parameters. solved: "
      "VerificationReport.solved of the same tiles, pins and membranes.");
}

}  // namespace curveups::bindings
