// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the built piece: the path from flat, and where its load cases end.
#include "curveups/actuation/actuated_design.hpp"
#include "curveups/bindings/bindings.hpp"

namespace curveups::bindings {
namespace {

// Load cases as report.json names them, in the order of LoadCase.
constexpr const char* load_names[] = {"relaxed", "by_itself", "shaken", "pressed"};

std::array<const std::optional<RestState>*, 4> states(const ActuatedDesign& design) {
  return {&design.relaxed, &design.released, &design.shaken, &design.pressed};
}

// Distances are None where the piece came to no rest.
py::object state_block(LoadCase load, const std::optional<RestState>& state) {
  if (!state) return py::none();
  py::dict out = py::cast(state->scan).attr("block");
  if (!state->at_rest) {
    for (const auto& [name, distance] : py::dict(out)) out[name] = py::none();
  }
  out["converged"] = state->at_rest;
  out["open_contacts"] = state->open_contacts;
  out["energy_n_mm"] = state->energy;
  out["steps"] = state->steps;
  if (load == LoadCase::relaxed) {
    out["element_change"] = state->element_change;
  } else {
    out["last_frame"] = state->last_frame;
  }
  if (load == LoadCase::shaken) out["taps"] = state->taps;
  if (load == LoadCase::pressed) out["force_n"] = state->force;
  return out;
}

// As report.json has it.
py::dict block(const ActuatedDesign& design) {
  py::dict out, spread;
  out["friction_coefficient"] = design.friction_coefficient;
  out["contacts"] = design.contacts;
  out["stopped"] = design.stopped;
  for (int k = 0; k < 4; ++k) {
    out[load_names[k]] = state_block(static_cast<LoadCase>(k), *states(design)[k]);
  }
  spread["mean_mm"] = design.spread;
  spread["varied"] = std::array<const char*, 2>{"friction", "membrane_mismatch"};
  out["spread"] = spread;
  return out;
}

std::vector<Eigen::VectorXd> deviations(const ActuatedDesign& design) {
  std::vector<Eigen::VectorXd> rows;
  for (const auto* state : states(design)) {
    if (*state) rows.push_back((*state)->deviation);
  }
  return rows;
}

}  // namespace

void bind_actuation(py::module_& module) {
  py::class_<PathFrame>(module, "PathFrame", "Positions of the tiles at one time of the path.")
      .def_property_readonly(
          "load", [](const PathFrame& frame) { return load_names[static_cast<int>(frame.load)]; },
          "by_itself, shaken or pressed.")
      .def_readonly("tiles", &PathFrame::tiles,
                    "Motion of each tile from its place in the actuated design: x, y, z (mm) and "
                    "a unit quaternion (w, x, y, z).")
      .def_readonly("time", &PathFrame::time, "s, with a drag of 1 N s / mm between neighbours.")
      .def_readonly("energy", &PathFrame::energy, "Stored energy, N mm.")
      .def_readonly("stretch", &PathFrame::stretch,
                    "Mean stretch ratio of the membranes between pins.");
  py::class_<ActuatedDesign>(module, "ActuatedDesign", "Shape of the built piece, and its path.")
      .def_property_readonly("block", &block, "Figures, as report.json has them.")
      .def_property_readonly("deviations", &deviations,
                             "For each state that was reached: mean distance of each tile's front "
                             "from the target, mm.")
      .def_property_readonly(
          "relaxed", [](const ActuatedDesign& design) { return design.relaxed->tiles; },
          "Relaxed tiles, as those of a frame.")
      .def_readonly("frames", &ActuatedDesign::frames);
  module.def(
      "actuate_design",
      [](const Design& design, const Progress& progress) {
        return actuate_design(design, {}, ProgressScope(progress).sink());
      },
      py::arg("design"), py::arg("progress") = py::none(), Released(),
      "Relaxes a piece without friction, releases it from flat, shakes it, presses it over its "
      "former and lets it go.");
}

}  // namespace curveups::bindings
