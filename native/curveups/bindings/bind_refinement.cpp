// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair of weak contacts.
#include "curveups/bindings/bindings.hpp"
#include "curveups/refinement/pin_relief.hpp"
#include "curveups/refinement/repair.hpp"

namespace curveups::bindings {

void bind_refinement(py::module_& module) {
  py::class_<RepairStep>(module, "RepairStep", "One step of a repair and what it left.")
      .def_readonly("weak_points", &RepairStep::weak_points)
      .def_readonly("least_force", &RepairStep::least_force, "In units of f_min.")
      .def_readonly("least_floor", &RepairStep::least_floor,
                    "Of the unilateral problem, in units of f_min; NaN where not looked at.")
      .def_readonly("vertices", &RepairStep::vertices, "Whether vertices moved.")
      .def_readonly("largest_move_mm", &RepairStep::largest_move)
      .def_readonly("fresh_mesh", &RepairStep::fresh_mesh);
  py::class_<BlockedContact>(module, "BlockedContact", "A contact that stays weak, and why.")
      .def_readonly("tiles", &BlockedContact::tiles)
      .def_readonly("least_force", &BlockedContact::least_force, "In units of f_min.")
      .def_readonly("reason", &BlockedContact::reason)
      .def_readonly("obstacle", &BlockedContact::obstacle,
                    "The kind of constraint that holds it, empty where none does.")
      .def_readonly("held", &BlockedContact::held);
  py::class_<RepairResult>(module, "RepairResult", "A repaired design and how it was found.")
      .def_readonly("design", &RepairResult::design)
      .def_property_readonly("status",
                             [](const RepairResult& r) {
                               return r.status == RepairStatus::valid     ? "valid"
                                      : r.status == RepairStatus::stopped ? "stopped"
                                                                          : "blocked";
                             })
      .def_readonly("steps", &RepairResult::steps)
      .def_readonly("restored_mm", &RepairResult::restored_mm)
      .def_readonly("largest_move_mm", &RepairResult::largest_move)
      .def_readonly("largest_vertex_move_mm", &RepairResult::largest_vertex_move)
      .def_readonly("solved", &RepairResult::solved, "For verify_design, where it is valid.")
      .def_readonly("blocked", &RepairResult::blocked)
      .def_readonly("suggestions", &RepairResult::suggestions);
  module.def(
      "repair_design",
      [](const Design& design, std::shared_ptr<SolvedDesign> solved, py::object progress) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return repair_design(design, {}, solved.get(), sink);
        });
      },
      py::arg("design"), py::arg("solved") = py::none(), py::arg("progress") = py::none(),
      "Lifts contact forces above f_min by the least steps of poses, pins and, where these do not "
      "do, vertices. solved: what verification of this design kept; it is taken over.");
  py::class_<SmallPin>(module, "SmallPin", "A pin side whose bounds leave less than A_pin_min.")
      .def_readonly("tile", &SmallPin::tile)
      .def_property_readonly(
          "side", [](const SmallPin& p) { return p.side == Side::front ? "front" : "back"; })
      .def_readonly("area", &SmallPin::area, "mm2");
  py::class_<PinRelief>(module, "PinRelief", "Vertices moved so that pins have room.")
      .def_property_readonly("V", [](const PinRelief& r) { return r.mesh.V; })
      .def_readonly("largest_move_mm", &PinRelief::largest_move)
      .def_readonly("relieved", &PinRelief::relieved)
      .def_readonly("remaining", &PinRelief::remaining);
  module.def(
      "relieve_pins",
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters,
         py::object progress) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return relieve_pins({V, F}, cuts, parameters, sink);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(),
      "Moves vertices a little where folds leave pin sides less than A_pin_min.");
}

}  // namespace curveups::bindings
