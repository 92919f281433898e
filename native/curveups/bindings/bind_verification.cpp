// SPDX-License-Identifier: LGPL-2.1-or-later
// The exact physical model and its verdict, and repair.
#include <algorithm>

#include "curveups/bindings/bindings.hpp"
#include "curveups/physics/membrane_figures.hpp"
#include "curveups/physics/solved_design.hpp"
#include "curveups/physics/verification.hpp"
#include "curveups/refinement/repair.hpp"

namespace curveups::bindings {
namespace {

std::array<int, 2> as_list(const int (&pair)[2]) { return {pair[0], pair[1]}; }

void bind_figures(py::module_& module) {
  using Physics = PhysicsFigures;
  FiguresClass<Physics>(module, "PhysicsFigures",
                        "Figures of both membranes, sides as [front, "
                        "back]; iterations on the coarse and fine mesh.")
      .figure("triangles", &Physics::triangles)
      .figure("free_vertices", &Physics::free_vertices)
      .figure("newton_iterations",
              [](const Physics& f) {
                return std::array<int, 2>{std::max(f.coarse_iterations[0], f.fine_iterations[0]),
                                          std::max(f.coarse_iterations[1], f.fine_iterations[1])};
              })
      .figure("newton_iterations_coarse",
              [](const Physics& f) { return as_list(f.coarse_iterations); })
      .figure("newton_iterations_fine", [](const Physics& f) { return as_list(f.fine_iterations); })
      .figure("converged", &Physics::converged)
      .figure("residual", &Physics::residual)
      .figure("wrinkled_fraction", &Physics::wrinkled_fraction)
      .figure("slack_fraction", &Physics::slack_fraction)
      .figure("largest_stretch", &Physics::largest_stretch)
      .figure("stretch_99", &Physics::stretch_99)
      .figure("force_balance", &Physics::force_balance)
      .figure("torque_balance", &Physics::torque_balance)
      .figure("normal_force_error", &Physics::normal_force_error)
      .figure("largest_normal_force_error", &Physics::largest_normal_force_error)
      .figure("least_force_error", &Physics::least_force_error)
      .figure("refined_tiles", &Physics::refined_tiles)
      .figure("membrane_clearance_mm", &Physics::clearance_mm)
      .figure("mean_tile_force", &Physics::mean_tile_force);
  using Contact = ContactFigures;
  FiguresClass<Contact>(module, "ContactFigures", "Contact forces by least squares, in N.")
      .figure("unit", [](const Contact&) { return "N"; })
      .figure("normal_mean", &Contact::normal_mean)
      .figure("normal_min", &Contact::normal_min)
      .figure("f_min", &Contact::f_min)
      .figure("points", &Contact::points)
      .figure("points_below_f_min", &Contact::points_below_f_min)
      .figure("pulling_points", &Contact::pulling_points)
      .figure("invalid_contacts", &Contact::invalid_contacts)
      .figure("friction_ratio_mean", &Contact::friction_ratio_mean)
      .figure("friction_ratio_max", &Contact::friction_ratio_max)
      .figure("imbalance", &Contact::imbalance);
  using Unilateral = UnilateralFigures;
  FiguresClass<Unilateral>(module, "UnilateralFigures", "Pushing forces within friction, in N.")
      .figure("feasible", &Unilateral::feasible)
      .figure("friction_coefficient", &Unilateral::friction_coefficient)
      .figure("floor", &Unilateral::floor)
      .figure("largest_floor", &Unilateral::largest_floor)
      .figure("status",
              [](const Unilateral& f) {
                return f.status == SolveStatus::converged    ? "feasible"
                       : f.status == SolveStatus::infeasible ? "infeasible"
                                                             : "unsolved";
              })
      .figure("feasible_at_bump_tips", &Unilateral::feasible_at_tips);
  FiguresClass<GlueLoad>(module, "GlueLoad", "A pin.")
      .figure("tile", &GlueLoad::tile)
      .figure("side", [](const GlueLoad& load) { return side_name(load.side); });
  using Glue = LargestGlueLoads;
  FiguresClass<Glue>(module, "LargestGlueLoads", "Largest loads of glue, and the pins there.")
      .figure("shear_max_mpa", [](const Glue& glue) { return glue.shear.shear; })
      .figure("shear_limit_mpa", [](const Glue& glue) { return glue.shear.limit; })
      .figure("shear_at", &Glue::shear)
      .figure("peel_max_n_per_mm", [](const Glue& glue) { return glue.peel.peel; })
      .figure("peel_at", &Glue::peel);
}

// Blocks of report.json.
py::dict blocks(const VerificationReport& report) {
  py::dict out;
  if (!report.computed) return out;
  out["physics"] = py::cast(report.physics).attr("block");
  out["contact_forces"] = py::cast(report.contact_forces).attr("block");
  if (report.complete) {
    out["unilateral"] = py::cast(report.unilateral).attr("block");
    if (const auto& play = report.unilateral.sliding_play) {
      out["unilateral"]["sliding_play_mm"] = *play;
    }
  }
  out["glue"] = py::cast(report.glue).attr("block");
  return out;
}

void bind_repair(py::module_& module) {
  FiguresClass<RepairStep>(module, "RepairStep", "One step of a repair and its result.")
      .figure("weak_points", &RepairStep::weak_points)
      .figure("least_force_of_f_min", &RepairStep::least_force)
      .figure("least_floor_of_f_min", &RepairStep::least_floor,
              "Of the unilateral problem; NaN where it was not computed.")
      .figure("vertices", &RepairStep::vertices, "True where vertices moved.")
      .figure("fresh_mesh", &RepairStep::fresh_mesh);
  py::class_<BlockedContact>(module, "BlockedContact", "A contact that stays weak, and why.")
      .def_readonly("tiles", &BlockedContact::tiles)
      .def_readonly("reason", &BlockedContact::reason)
      .def_readonly("obstacle", &BlockedContact::obstacle,
                    "The kind of constraint that holds it, empty where none does.");
  FiguresClass<RepairResult>(module, "RepairResult", "A repaired design and how it was found.")
      .figure("status",
              [](const RepairResult& r) {
                return r.solve.converged() ? "valid" : r.solve.stopped() ? "stopped" : "blocked";
              })
      .figure("restored_mm", &RepairResult::restored_mm)
      .figure("largest_move_mm", &RepairResult::largest_move)
      .figure("largest_vertex_move_mm", &RepairResult::largest_vertex_move)
      .figure("steps", &RepairResult::steps)
      .def_readonly("design", &RepairResult::design)
      .def_readonly("blocked", &RepairResult::blocked)
      .def_readonly("cuts", &RepairResult::cuts,
                    "Findings on the deepest cut of either membrane into a body.")
      .def_readonly("breakdown", &RepairResult::breakdown,
                    "Why it ended early; empty where it did not.")
      .def_readonly("verification", &RepairResult::verification, "Of a valid result; or None.");
  module.def(
      "repair_design",
      [](const Design& design, const Progress& progress, const std::optional<Listener>& on_step,
         const SolvedPtr& solved) {
        return repair_design(design, ProgressScope(progress).sink(), native_listener(on_step),
                             most_repair_steps, solved);
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("on_step") = py::none(),
      py::arg("solved") = py::none(), Released(),
      "Lifts contact forces above f_min by the least steps of poses, pins and, where these do not "
      "do, vertices. on_step(T, q, weak_points, violation) gets every step and stops the work by "
      "returning False. solved: VerificationReport.solved of the same design.");
}

}  // namespace

void bind_verification(py::module_& module) {
  bind_figures(module);
  py::class_<MembranePicture>(module, "MembranePicture", "One membrane's mesh, for pictures.")
      .def_readonly("flat", &MembranePicture::flat, "N x 2, mm, in the layout.")
      .def_readonly("actuated", &MembranePicture::actuated, "N x 3, mm.")
      .def_readonly("triangles", &MembranePicture::triangles)
      .def_readonly("stretch", &MembranePicture::stretch, "Larger and smaller, per triangle.")
      .def_readonly("tension", &MembranePicture::tension, "0 taut, 1 wrinkled, 2 slack.");
  py::class_<SolvedDesign, SolvedPtr>(module, "SolvedDesign",
                                      "Membranes of a design at their equilibrium.");
  using Report = VerificationReport;
  py::class_<Report>(module, "VerificationReport", "The physical model and its verdict.")
      .def_readonly("valid", &Report::valid)
      .def_readonly("complete", &Report::complete,
                    "False without a verdict, where weak points were enough.")
      .def_readonly("reasons", &Report::reasons)
      .def_readonly("warnings", &Report::warnings)
      .def_property_readonly(
          "solved",
          [](const Report& report) { return std::const_pointer_cast<SolvedDesign>(report.solved); },
          "For repair_design and settle_design; None where nothing could be computed.")
      .def_property_readonly("blocks", &blocks, "physics, contact_forces, unilateral, glue.")
      .def_readonly("contact_tiles", &Report::contact_tiles, "K x 2: the tiles of every contact.")
      .def_readonly("contact_normal_min", &Report::contact_normal_min)
      .def_readonly("contact_normal_mean", &Report::contact_normal_mean)
      .def_readonly("contact_friction_ratio", &Report::contact_friction_ratio)
      .def_readonly("tile_normal_force", &Report::tile_normal_min,
                    "Least normal force at each tile's contact points, N.")
      .def_readonly("membranes", &Report::membrane, "Front and back.");
  module.def("surplus_tension", &surplus_tension, py::arg("parameters"),
             "N/mm along the rim of each sheet, front and back, stretched by tau in both "
             "directions.");
  module.def(
      "verify_design",
      [](const Design& design, const Progress& progress, bool weak_is_enough) {
        return verify_design(design, ProgressScope(progress).sink(), {weak_is_enough});
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("weak_is_enough") = false,
      Released(),
      "Membranes, contact forces and verdict. weak_is_enough: without a verdict where points push "
      "too weakly (complete is False).");
  bind_repair(module);
}

}  // namespace curveups::bindings
