// SPDX-License-Identifier: LGPL-2.1-or-later
// Shape of the built piece: the path from flat, and where its load cases end.
#include "curveups/actuation/actuated_design.hpp"
#include "curveups/bindings/bindings.hpp"
#include "curveups/bindings/scan_block.hpp"

namespace curveups::bindings {
namespace {

// States by their load cases, as report.json names them.
struct NamedState {
  const char* name;
  LoadCase load;
  std::optional<RestState> ActuatedDesign::*state;
};
constexpr NamedState states[] = {{"relaxed", LoadCase::relaxed, &ActuatedDesign::relaxed},
                                 {"by_itself", LoadCase::released, &ActuatedDesign::released},
                                 {"shaken", LoadCase::shaken, &ActuatedDesign::shaken},
                                 {"pressed", LoadCase::pressed, &ActuatedDesign::pressed}};

// Distances are None where the piece came to no rest.
py::object state_block(LoadCase load, const std::optional<RestState>& state) {
  if (!state) return py::none();
  py::dict out = scan_block(state->scan);
  if (!state->at_rest) {
    for (const auto& entry : scan_block(state->scan)) out[entry.first] = py::none();
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
  py::dict out;
  out["friction_coefficient"] = design.friction_coefficient;
  out["contacts"] = design.contacts;
  out["stopped"] = design.stopped;
  for (const auto& [name, load, state] : states) out[name] = state_block(load, design.*state);
  py::dict spread;
  spread["mean_mm"] = design.spread;
  spread["varied"] = std::vector<std::string>{"friction", "membrane_mismatch"};
  out["spread"] = spread;
  return out;
}

// A row a state that there is.
Eigen::MatrixXd deviations(const ActuatedDesign& design) {
  std::vector<Eigen::VectorXd> rows;
  for (const NamedState& named : states) {
    if (const auto& state = design.*named.state) rows.push_back(state->deviation);
  }
  Eigen::MatrixXd out(static_cast<Eigen::Index>(rows.size()), rows[0].size());
  for (Eigen::Index s = 0; s < out.rows(); ++s) out.row(s) = rows[s].transpose();
  return out;
}

template <double PathFrame::*Member>
Eigen::VectorXd of_frames(const ActuatedDesign& design) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(design.frames.size()));
  for (Eigen::Index k = 0; k < out.size(); ++k) out(k) = design.frames[k].*Member;
  return out;
}

std::vector<FrameRows> tiles_of_frames(const ActuatedDesign& design) {
  std::vector<FrameRows> out;
  for (const PathFrame& frame : design.frames) out.push_back(frame.tiles);
  return out;
}

std::vector<std::string> loads_of_frames(const ActuatedDesign& design) {
  std::vector<std::string> out;
  for (const PathFrame& frame : design.frames) {
    out.emplace_back(states[static_cast<int>(frame.load)].name);
  }
  return out;
}

}  // namespace

void bind_actuation(py::module_& module) {
  py::class_<ActuatedDesign>(module, "ActuatedDesign", "Shape of the built piece, and its path.")
      .def_property_readonly("block", &block, "Figures, as report.json has them.")
      .def_property_readonly("deviations", &deviations,
                             "Per state that there is and tile the mean distance of its front from "
                             "the target, mm.")
      .def_property_readonly(
          "relaxed", [](const ActuatedDesign& design) { return design.relaxed->tiles; },
          "Relaxed tiles, as a frame.")
      .def_property_readonly("frames", &tiles_of_frames,
                             "Per frame of the path a row a tile, its motion from its place in "
                             "the actuated design: x, y, z (mm) and a unit quaternion (w, x, y, "
                             "z).")
      .def_property_readonly("loads", &loads_of_frames,
                             "Load case of each frame: by_itself, shaken or pressed.")
      .def_property_readonly("time", &of_frames<&PathFrame::time>,
                             "Time of each frame, s, with a drag of 1 N s / mm between neighbours.")
      .def_property_readonly("energy", &of_frames<&PathFrame::energy>,
                             "Stored energy of each frame, N mm.")
      .def_property_readonly("stretch", &of_frames<&PathFrame::stretch>,
                             "Mean stretch ratio of the membranes between pins.");
  module.def(
      "actuate_design",
      [](const Design& design, py::object progress) {
        return without_gil(std::move(progress),
                           [&](const Progress& sink) { return actuate_design(design, {}, sink); });
      },
      py::arg("design"), py::arg("progress") = py::none(),
      "Relaxes a piece without friction, releases it from flat, shakes it, presses it over its "
      "former and lets it go.");
}

}  // namespace curveups::bindings
