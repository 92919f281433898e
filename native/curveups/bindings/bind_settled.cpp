// SPDX-License-Identifier: LGPL-2.1-or-later
// Settled forces and the shape that a piece has once its tiles have settled.
#include "curveups/bindings/bindings.hpp"
#include "curveups/contact/settled_design.hpp"

namespace curveups::bindings {
namespace {

// As report.json has it.
py::dict block(const SettledDesign& settled) {
  py::dict scan;
  scan["mean_mm"] = settled.scan.mean;
  scan["rms_mm"] = settled.scan.rms;
  scan["p95_mm"] = settled.scan.p95;
  scan["max_mm"] = settled.scan.largest;
  scan["hausdorff_mm"] = settled.scan.hausdorff;
  py::list open;
  for (const std::array<int, 2>& pair : settled.open_contacts) {
    open.append(py::make_tuple(pair[0], pair[1]));
  }
  py::dict out;
  out["friction_coefficient"] = settled.friction_coefficient;
  out["hold_tolerance_mm"] = settled.hold_tolerance;
  out["converged"] = settled.converged;
  out["normal_mean"] = settled.normal_mean;
  out["normal_min"] = settled.normal_min;
  out["open_contacts"] = open;
  out["largest_slip_mm"] = settled.largest_slip;
  out["drift_mm"] = settled.drift;
  out["holding_friction"] = settled.holding_friction;
  out["scan"] = scan;
  return out;
}

}  // namespace

void bind_settled(py::module_& module) {
  py::class_<SettledDesign>(module, "SettledDesign",
                            "What develops where a design's tiles are let go when actuated.")
      .def_readonly("holds", &SettledDesign::holds)
      .def_readonly("converged", &SettledDesign::converged)
      .def_property_readonly("block", &block, "The figures, as report.json has them.")
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
      .def_readonly("steps", &SettledDesign::steps)
      .def_readonly("iterations", &SettledDesign::iterations)
      .def_readonly("factorizations", &SettledDesign::factorizations);
  module.def(
      "settle_design",
      [](const Design& design, SolutionStore* store, py::object progress, bool holding_friction,
         double hold_tolerance, double tile_modulus) {
        SettleOptions options;
        options.find_holding_friction = holding_friction;
        options.hold_tolerance = hold_tolerance;
        options.tile_modulus = tile_modulus;
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return settle_design(design, store, options, sink);
        });
      },
      py::arg("design"), py::arg("store") = py::none(), py::arg("progress") = py::none(),
      py::arg("holding_friction") = true, py::arg("hold_tolerance") = 0.0,
      py::arg("tile_modulus") = 2000.0,
      "Lets the tiles of a design settle from where they stand when actuated. store: as in "
      "verify_design. holding_friction: whether smaller coefficients are tried as well. "
      "hold_tolerance: mm, 0 for 1 % of L. tile_modulus: Young's modulus of the tiles, MPa.");
}

}  // namespace curveups::bindings
