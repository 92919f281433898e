// SPDX-License-Identifier: LGPL-2.1-or-later
// From flat to shape: paths of a piece, and what they answer.
#include "curveups/actuation/actuated_design.hpp"
#include "curveups/bindings/bindings.hpp"
#include "curveups/bindings/scan_block.hpp"

namespace curveups::bindings {
namespace {

py::list pairs_list(const std::vector<std::array<int, 2>>& pairs) {
  py::list out;
  for (const std::array<int, 2>& pair : pairs) out.append(py::make_tuple(pair[0], pair[1]));
  return out;
}

py::dict end_block(const ActuatedDesign& found, const PathEnd& end) {
  py::dict out;
  out["friction_coefficient"] = end.friction_coefficient;
  out["converged"] = end.at_rest;
  out["arrives"] =
      end.at_rest && found.from_target.at_rest ? py::cast(found.has_arrived(end)) : py::none();
  out["energy_n_mm"] = end.energy;
  out["shortfall_mm"] = end.shortfall;
  out["open_contacts"] = pairs_list(end.open_contacts);
  out["wedged"] = pairs_list(end.wedged);
  out["scan"] = scan_block(end.scan);
  out["steps"] = end.steps;
  out["iterations"] = end.iterations;
  out["factorizations"] = end.factorizations;
  return out;
}

// As report.json has it.
py::dict block(const ActuatedDesign& found) {
  py::dict out = end_block(found, found.end);
  out["arrives"] = found.arrives;
  out["contacts"] = found.contacts;
  out["tolerance_mm"] = found.tolerance;
  out["stopped"] = found.path.stopped;
  out["largest_rise_n_mm"] = found.path.largest_rise;
  out["found_anew_n_mm"] = found.path.found_anew;
  out["deepest_mm"] = found.path.deepest;
  out["from_target"] = end_block(found, found.from_target);
  out["reach_friction"] = found.reach_friction;
  out["trap"] = found.trap;
  if (!found.sampled.empty()) {
    py::list sampled;
    for (const PathEnd& end : found.sampled) sampled.append(end_block(found, end));
    out["sampled"] = sampled;
    out["scan_frictionless"] = scan_block(found.sampled.front().scan);
    out["frictionless_from_target"] = end_block(found, found.frictionless_from_target);
    out["trap_distance_mm"] = found.trap_distance;
  }
  return out;
}

template <double PathFrame::*Member>
Eigen::VectorXd of_frames(const ActuatedDesign& found) {
  Eigen::VectorXd out(found.path.frames.size());
  for (Eigen::Index k = 0; k < out.size(); ++k) out(k) = found.path.frames[k].*Member;
  return out;
}

}  // namespace

void bind_actuation(py::module_& module) {
  py::class_<ActuatedDesign>(module, "ActuatedDesign", "How a design gets from flat to shape.")
      .def_readonly("arrives", &ActuatedDesign::arrives,
                    "Whether it arrives by itself; None without an answer.")
      .def_property_readonly("block", &block, "The figures, as report.json has them.")
      .def_readonly("frames", &ActuatedDesign::frames,
                    "Per frame of the path a row a tile, how it has moved from its place in the "
                    "actuated design: x, y, z (mm) and a unit quaternion (w, x, y, z).")
      .def_property_readonly("time", &of_frames<&PathFrame::time>,
                             "Of the frames, s, with a drag of 1 N s / mm on every tile.")
      .def_property_readonly("energy", &of_frames<&PathFrame::energy>, "Stored, N mm.")
      .def_property_readonly("friction", &of_frames<&PathFrame::friction>,
                             "What friction has taken until then, N mm.")
      .def_property_readonly("stretch", &of_frames<&PathFrame::stretch>,
                             "Mean stretch ratio of the membranes between pins.")
      .def_readonly("corners", &ActuatedDesign::corners,
                    "Front corners of the last frame, three rows a tile, fitted to the design, mm.")
      .def_readonly("deviation", &ActuatedDesign::deviation,
                    "Mean distance of each tile from the design's surface there, mm.");
  module.def(
      "actuate_design",
      [](const Design& design, SolutionStore* store, py::object progress,
         std::optional<FrameRows> begin, bool answers) {
        ActuationOptions options;
        options.start = std::move(begin);
        options.answers = answers;
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return actuate_design(design, store, options, sink);
        });
      },
      py::arg("design"), py::arg("store") = py::none(), py::arg("progress") = py::none(),
      py::arg("begin") = py::none(), py::arg("answers") = true,
      "Lets a piece rise from flat, or from a frame of an earlier path. store: as in "
      "verify_design. answers: whether it is asked at which friction it arrives, and whether it "
      "could come to rest elsewhere; a path from a frame has none of these.");
}

}  // namespace curveups::bindings
