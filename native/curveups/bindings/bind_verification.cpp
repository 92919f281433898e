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

const char* status_name(SolveStatus status) {
  return status == SolveStatus::converged    ? "feasible"
         : status == SolveStatus::infeasible ? "infeasible"
                                             : "unsolved";
}

py::dict physics_block(const PhysicsFigures& f) {
  py::dict out;
  out["triangles"] = f.triangles;
  out["free_vertices"] = f.free_vertices;
  // Per side: the most on one of its two meshes; then the coarser and the finer by themselves.
  out["newton_iterations"] = py::make_tuple(std::max(f.coarse_iterations[0], f.fine_iterations[0]),
                                            std::max(f.coarse_iterations[1], f.fine_iterations[1]));
  out["newton_iterations_coarse"] = py::make_tuple(f.coarse_iterations[0], f.coarse_iterations[1]);
  out["newton_iterations_fine"] = py::make_tuple(f.fine_iterations[0], f.fine_iterations[1]);
  out["converged"] = f.converged;
  out["residual"] = f.residual;
  out["wrinkled_fraction"] = f.wrinkled_fraction;
  out["stretch_99"] = f.stretch_99;
  out["force_balance"] = f.force_balance;
  out["torque_balance"] = f.torque_balance;
  out["normal_force_error"] = f.normal_force_error;
  out["largest_normal_force_error"] = f.largest_normal_force_error;
  out["least_force_error"] = f.least_force_error;
  out["membrane_clearance_mm"] = f.clearance_mm;
  out["mean_tile_force"] = f.mean_tile_force;
  return out;
}

py::dict contact_block(const ContactFigures& f) {
  py::dict out;
  out["unit"] = "N";
  out["normal_mean"] = f.normal_mean;
  out["normal_min"] = f.normal_min;
  out["f_min"] = f.f_min;
  out["points"] = f.points;
  out["points_below_f_min"] = f.points_below_f_min;
  out["pulling_points"] = f.pulling_points;
  out["invalid_contacts"] = f.invalid_contacts;
  out["friction_ratio_mean"] = f.friction_ratio_mean;
  out["friction_ratio_max"] = f.friction_ratio_max;
  out["imbalance"] = f.imbalance;
  return out;
}

py::dict unilateral_block(const UnilateralFigures& f) {
  py::dict out;
  out["feasible"] = f.feasible;
  out["friction_coefficient"] = f.friction_coefficient;
  out["floor"] = f.floor;
  out["largest_floor"] = f.largest_floor;
  out["status"] = status_name(f.status);
  out["feasible_at_bump_tips"] = f.feasible_at_tips;
  if (f.sliding_play) out["sliding_play_mm"] = *f.sliding_play;
  return out;
}

py::dict glue_block(const GlueFigures& glue) {
  py::dict out;
  auto where = [&](const char* name, const GlueLoad& load) {
    py::dict place;
    place["tile"] = load.tile;
    place["side"] = load.side == Side::front ? "front" : "back";
    out[name] = place;
  };
  out["shear_max_mpa"] = glue.shear.shear;
  out["shear_limit_mpa"] = glue.limit;
  where("shear_at", glue.shear);
  out["peel_max_n_per_mm"] = glue.peel.peel;
  where("peel_at", glue.peel);
  return out;
}

py::dict blocks(const VerificationReport& report) {
  py::dict out;
  if (!report.computed) return out;
  out["physics"] = physics_block(report.physics);
  out["contact_forces"] = contact_block(report.contact_forces);
  if (report.complete) out["unilateral"] = unilateral_block(report.unilateral);
  out["glue"] = glue_block(report.glue);
  return out;
}

template <class Member>
auto array(Member VerificationReport::*member) {
  return [member](const VerificationReport& report) { return report.*member; };
}

}  // namespace

void bind_verification(py::module_& module) {
  py::class_<MembranePicture>(module, "MembranePicture", "One membrane's mesh, for pictures.")
      .def_readonly("flat", &MembranePicture::flat, "N x 2, mm, in the layout.")
      .def_readonly("actuated", &MembranePicture::actuated, "N x 3, mm.")
      .def_readonly("triangles", &MembranePicture::triangles)
      .def_readonly("stretch", &MembranePicture::stretch, "Larger and smaller, per triangle.")
      .def_readonly("tension", &MembranePicture::tension, "0 taut, 1 wrinkled, 2 slack.");
  py::class_<SolvedDesign, SolvedPtr>(module, "SolvedDesign",
                                      "Membranes of a design at their equilibrium.");
  py::class_<VerificationReport>(module, "VerificationReport",
                                 "The physical model and its verdict.")
      .def_readonly("valid", &VerificationReport::valid)
      .def_readonly("complete", &VerificationReport::complete,
                    "Whether there is a verdict: not where weak points were enough.")
      .def_readonly("reasons", &VerificationReport::reasons)
      .def_readonly("warnings", &VerificationReport::warnings)
      .def_property_readonly(
          "solved",
          [](const VerificationReport& report) {
            return std::const_pointer_cast<SolvedDesign>(report.solved);
          },
          "For repair_design and settle_design; None where nothing could be computed.")
      .def_property_readonly("blocks", &blocks, "physics, contact_forces, unilateral, glue.")
      .def_property_readonly("contact_tiles", array(&VerificationReport::contact_tiles),
                             "K x 2: the tiles of every contact.")
      .def_property_readonly("contact_normal_min", array(&VerificationReport::contact_normal_min))
      .def_property_readonly("contact_normal_mean", array(&VerificationReport::contact_normal_mean))
      .def_property_readonly("contact_friction_ratio",
                             array(&VerificationReport::contact_friction_ratio))
      .def_property_readonly("tile_normal_force", array(&VerificationReport::tile_normal_min),
                             "Least normal force at each tile's contact points, N.")
      .def_property_readonly("membranes", [](const VerificationReport& report) {
        return py::make_tuple(report.membrane[0], report.membrane[1]);
      });
  module.def(
      "surplus_tension", [](const Parameters& parameters) { return surplus_tension(parameters); },
      py::arg("parameters"),
      "N/mm along the rim of each sheet, front and back, stretched by tau in both directions.");
  module.def(
      "verify_design",
      [](const Design& design, py::object progress, bool weak_is_enough) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return verify_design(design, sink, {weak_is_enough});
        });
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("weak_is_enough") = false,
      "Membranes, contact forces and verdict. weak_is_enough: without a verdict where points push "
      "too weakly (complete is False).");

  py::class_<RepairStep>(module, "RepairStep", "One step of a repair and what it left.")
      .def_readonly("weak_points", &RepairStep::weak_points)
      .def_readonly("least_force", &RepairStep::least_force, "In units of f_min.")
      .def_readonly("least_floor", &RepairStep::least_floor,
                    "Of the unilateral problem, in units of f_min; NaN where not looked at.")
      .def_readonly("vertices", &RepairStep::vertices, "Whether vertices moved.")
      .def_readonly("fresh_mesh", &RepairStep::fresh_mesh);
  py::class_<BlockedContact>(module, "BlockedContact", "A contact that stays weak, and why.")
      .def_readonly("tiles", &BlockedContact::tiles)
      .def_readonly("reason", &BlockedContact::reason);
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
      .def_readonly("cuts", &RepairResult::cuts,
                    "Where either membrane cuts deepest into a body, as verification's reasons.")
      .def_readonly("breakdown", &RepairResult::breakdown,
                    "Why it ended early; empty where it did not.")
      .def_readonly("verification", &RepairResult::verification, "Of a valid result; or None.");
  module.def(
      "repair_design",
      [](const Design& design, py::object progress, py::object on_step, const SolvedPtr& solved) {
        PythonListener listener(std::move(on_step));
        const PythonListener::Function function = listener.function();
        RepairResult result = without_gil(std::move(progress), [&](const Progress& sink) {
          return repair_design(design, sink, function, most_repair_steps, solved);
        });
        listener.rethrow();
        return result;
      },
      py::arg("design"), py::arg("progress") = py::none(), py::arg("on_step") = py::none(),
      py::arg("solved") = py::none(),
      "Lifts contact forces above f_min by the least steps of poses, pins and, where these do not "
      "do, vertices. on_step(T, q, weak_points) gets every step and stops the work by returning "
      "False. solved: VerificationReport.solved of the same design.");
}

}  // namespace curveups::bindings
