// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair of weak contacts.
#include "curveups/bindings/bindings.hpp"
#include "curveups/refinement/repair.hpp"

namespace curveups::bindings {

void bind_repair(py::module_& module) {
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
      .def_property_readonly(
          "status",
          [](const RepairResult& r) {
            return r.solve.converged() ? "valid" : r.solve.stopped() ? "stopped" : "blocked";
          })
      .def_readonly("steps", &RepairResult::steps)
      .def_readonly("restored_mm", &RepairResult::restored_mm)
      .def_readonly("largest_move_mm", &RepairResult::largest_move)
      .def_readonly("largest_vertex_move_mm", &RepairResult::largest_vertex_move)
      .def_readonly("blocked", &RepairResult::blocked)
      .def_readonly("suggestions", &RepairResult::suggestions);
  module.def(
      "repair_design",
      [](const Design& design, SolutionStore* store, py::object progress, py::object on_step) {
        PythonListener listener(std::move(on_step));
        const PythonListener::Function function = listener.function();
        RepairResult result = without_gil(std::move(progress), [&](const Progress& sink) {
          return repair_design(design, {}, store, sink, function);
        });
        listener.rethrow();
        return result;
      },
      py::arg("design"), py::arg("store") = py::none(), py::arg("progress") = py::none(),
      py::arg("on_step") = py::none(),
      "Lifts contact forces above f_min by the least steps of poses, pins and, where these do not "
      "do, vertices. store: as in verify_design; a valid result leaves what was solved of it. "
      "on_step(T, q, weak_points) gets every step and stops the work by returning False.");
}

}  // namespace curveups::bindings
