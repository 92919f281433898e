// SPDX-License-Identifier: LGPL-2.1-or-later
// From flat to shape: paths of a piece, and what they answer.
#include "curveups/actuation/actuated_design.hpp"
#include "curveups/actuation/path_memory.hpp"
#include "curveups/bindings/bindings.hpp"
#include "curveups/bindings/scan_block.hpp"

namespace curveups::bindings {
namespace {

py::dict end_block(const ActuatedDesign& found, const PathEnd& end) {
  py::dict out;
  out["friction_coefficient"] = end.friction_coefficient;
  out["converged"] = end.at_rest;
  out["arrives"] =
      end.at_rest && found.from_target.at_rest ? py::cast(found.has_arrived(end)) : py::none();
  out["energy_n_mm"] = end.energy;
  out["normal_mean"] = end.push;
  out["shortfall_mm"] = end.shortfall;
  out["open_contacts"] = end.open_contacts;
  out["wedged"] = end.wedged;
  out["scan"] = scan_block(end.scan);
  out["steps"] = end.steps;
  out["iterations"] = end.iterations;
  out["factorizations"] = end.factorizations;
  return out;
}

const char* word_of(Homecoming reached) {
  switch (reached) {
    case Homecoming::home:
      return "home";
    case Homecoming::shape:
      return "shape";
    default:
      return "none";
  }
}

void add_hands(const ActuatedDesign& found, py::dict& out) {
  const Hands& hands = *found.hands;
  py::list touches;
  for (const HandTouch& touch : hands.touches) {
    py::dict one;
    one["tiles"] = touch.tiles;
    one["direction"] =
        std::array<double, 3>{touch.direction.x(), touch.direction.y(), touch.direction.z()};
    one["way"] = touch.outward > 0.5 ? "outwards" : touch.outward < -0.5 ? "inwards" : "sideways";
    one["force_n"] = touch.force;
    touches.append(one);
  }
  out["hands"] = touches;
  py::dict by_hand;
  by_hand["taps"] = hands.taps;
  by_hand["shaken"] = end_block(found, hands.shaken);
  by_hand["end"] = end_block(found, hands.end);
  by_hand["reached"] = word_of(hands.reached);
  by_hand["shaken_frame"] = hands.shaking_frames - 1;
  by_hand["tried"] = hands.tried;
  by_hand["largest_force_n"] = hands.largest_force;
  by_hand["largest_rise_n_mm"] = hands.largest_rise;
  out["by_hand"] = by_hand;
}

// What came before the piece was cut out, and the end.
void add_release(const ActuatedDesign& found, py::dict& out) {
  out["release"] = found.release;
  py::dict surplus;
  surplus["anchors"] = found.surplus->anchors;
  surplus["box_mm"] = std::array<double, 2>{found.surplus->box.x(), found.surplus->box.y()};
  surplus["window_mm"] =
      std::array<double, 2>{found.surplus->window.x(), found.surplus->window.y()};
  out["surplus"] = surplus;
  py::list phases;
  for (const PathPhase& phase : found.phases) {
    py::dict one = end_block(found, phase.end);
    one["phase"] = phase.name;
    one["first_frame"] = phase.first_frame;
    one["removed_n_mm"] = phase.removed;
    phases.append(one);
  }
  out["phases"] = phases;
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
  if (found.hands) add_hands(found, out);
  if (found.surplus) add_release(found, out);
  return out;
}

// The path's frames, then those of hands, which go on from its end.
template <double PathFrame::*Member>
Eigen::VectorXd of_frames(const ActuatedDesign& found) {
  std::vector<double> out;
  for (const PathFrame& frame : found.path.frames) out.push_back(frame.*Member);
  if (found.hands) {
    for (const PathFrame& frame : found.hands->frames) out.push_back(frame.*Member);
  }
  return Eigen::Map<const Eigen::VectorXd>(out.data(), static_cast<Eigen::Index>(out.size()));
}

std::vector<Eigen::VectorXd> memories(const ActuatedDesign& found) {
  std::vector<Eigen::VectorXd> out;
  for (const PathFrame& frame : found.path.frames) out.push_back(frame.memory);
  return out;
}

}  // namespace

void bind_actuation(py::module_& module) {
  module.attr("MEMORY_FORMAT") = memory_format;  // of the memories of frames
  py::class_<ActuatedDesign>(module, "ActuatedDesign", "How a design gets from flat to shape.")
      .def_readonly("arrives", &ActuatedDesign::arrives,
                    "Whether it arrives by itself; None without an answer.")
      .def_property_readonly("block", &block, "The figures, as report.json has them.")
      .def_readonly("frames", &ActuatedDesign::frames,
                    "Per frame of the path a row a tile, how it has moved from its place in the "
                    "actuated design: x, y, z (mm) and a unit quaternion (w, x, y, z).")
      .def_readonly("hand_frames", &ActuatedDesign::hand_frames,
                    "The same of hands, from where the path ends.")
      .def_property_readonly("hand_work", &of_frames<&PathFrame::hands>,
                             "What hands have put in until then, N mm; of all frames.")
      .def_property_readonly("time", &of_frames<&PathFrame::time>,
                             "Of the frames, s, with a drag of 1 N s / mm between neighbours.")
      .def_property_readonly("energy", &of_frames<&PathFrame::energy>, "Stored, N mm.")
      .def_property_readonly("friction", &of_frames<&PathFrame::friction>,
                             "What friction has taken until then, N mm.")
      .def_property_readonly("stretch", &of_frames<&PathFrame::stretch>,
                             "Mean stretch ratio of the membranes between pins.")
      .def_property_readonly("memories", &memories,
                             "Of the path's frames: what a path that begins there needs to go on "
                             "as it would have. Empty where there is no room for it, but of the "
                             "last one, and of a piece with its surplus.")
      .def_readonly("corners", &ActuatedDesign::corners,
                    "Front corners of the last frame, three rows a tile, fitted to the design, mm.")
      .def_readonly("deviation", &ActuatedDesign::deviation,
                    "Mean distance of each tile from the design's surface there, mm.");
  module.def(
      "actuate_design",
      [](const Design& design, py::object progress,
         std::optional<FrameRows> begin, std::optional<Eigen::VectorXd> memory, bool answers,
         bool hands, const std::string& release, std::vector<int> press,
         std::optional<double> force) {
        ActuationOptions options;
        options.hands = hands;
        options.touch = {std::move(press), force};
        options.release = release;
        options.start = std::move(begin);
        options.memory = std::move(memory);
        options.answers = answers;
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return actuate_design(design, options, sink);
        });
      },
      py::arg("design"), py::arg("progress") = py::none(),
      py::arg("begin") = py::none(), py::arg("memory") = py::none(), py::arg("answers") = true,
      py::arg("hands") = true, py::arg("release") = "cut", py::arg("press") = std::vector<int>(),
      py::arg("force") = py::none(),
      "Lets a piece rise from flat, or from a frame of an earlier path. "
      "memory: of a path that came by `begin`. answers: whether it is asked at "
      "which friction it arrives, and whether it could come to rest elsewhere; a path from a "
      "frame has none of these. hands: with the "
      "answers, what brings it home by hand where it does not arrive. release: how hands release "
      "a piece from the rings of its sheets: cut (out of both at once), together, front-first or "
      "back-first (with anchors and surplus, which are cut off last). press: the tiles that hands "
      "press instead of looking for some, with a force of so many N on each, or twice the mean "
      "normal force of a contact.");
}

}  // namespace curveups::bindings
