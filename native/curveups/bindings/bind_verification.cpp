// SPDX-License-Identifier: LGPL-2.1-or-later
// The exact physical model and its verdict.
#include <algorithm>

#include "curveups/bindings/bindings.hpp"
#include "curveups/physics/verification.hpp"

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
  out["slack_fraction"] = f.slack_fraction;
  out["largest_stretch"] = f.largest_stretch;
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
  py::list invalid;
  for (const std::array<int, 2>& pair : f.invalid_contacts) {
    invalid.append(py::make_tuple(pair[0], pair[1]));
  }
  out["invalid_contacts"] = invalid;
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
  out["status_unlimited_friction"] = status_name(f.unlimited_status);
  out["largest_floor_unlimited_friction"] = f.unlimited_largest_floor;
  if (f.tips_status) {
    out["feasible_at_bump_tips"] = f.feasible_at_tips;
    out["status_at_bump_tips"] = status_name(*f.tips_status);
    out["largest_floor_at_bump_tips"] = f.tips_largest_floor;
  } else {
    out["feasible_at_bump_tips"] = py::none();
  }
  if (f.sliding_play) out["sliding_play_mm"] = *f.sliding_play;
  return out;
}

py::dict glue_block(const LargestGlueLoads& glue) {
  py::dict out;
  auto where = [&](const char* name, const GlueLoad& load) {
    py::dict place;
    place["tile"] = load.tile;
    place["side"] = load.side == Side::front ? "front" : "back";
    out[name] = place;
  };
  out["shear_max_mpa"] = glue.shear.shear;
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

py::list warnings(const VerificationReport& report) {
  py::list out;
  for (const Warning& warning : report.warnings) {
    py::dict one;
    one["what"] = warning.what;
    one["tiles"] = warning.tiles;
    out.append(one);
  }
  return out;
}

py::dict to_dict(const VerificationReport& report) {
  py::dict out = blocks(report);
  out["valid"] = report.valid;
  out["reasons"] = report.reasons;
  out["warnings"] = warnings(report);
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
  py::class_<VerificationReport>(module, "VerificationReport",
                                 "The physical model and its verdict.")
      .def_readonly("valid", &VerificationReport::valid)
      .def_readonly("complete", &VerificationReport::complete,
                    "Whether there is a verdict: not where weak points were enough.")
      .def_readonly("reasons", &VerificationReport::reasons)
      .def_property_readonly("warnings", &warnings)
      .def_property_readonly("blocks", &blocks, "physics, contact_forces, unilateral, glue.")
      .def("to_dict", &to_dict, "The blocks with valid, reasons and warnings.")
      .def_property_readonly(
          "contact_tiles",
          [](const VerificationReport& report) {
            Edges out(report.contact_tiles.size(), 2);
            for (Eigen::Index k = 0; k < out.rows(); ++k) {
              out.row(k) << report.contact_tiles[k][0], report.contact_tiles[k][1];
            }
            return out;
          },
          "K x 2: the tiles of every contact.")
      .def_property_readonly("contact_normal_min", array(&VerificationReport::contact_normal_min))
      .def_property_readonly("contact_normal_mean", array(&VerificationReport::contact_normal_mean))
      .def_property_readonly("contact_friction_ratio",
                             array(&VerificationReport::contact_friction_ratio))
      .def_property_readonly("tile_normal_force", array(&VerificationReport::tile_normal_min),
                             "Least normal force at each tile's contact points, N.")
      .def_property_readonly("elastic_wrenches", array(&VerificationReport::elastic),
                             "M x 6: membranes' force (N) and torque about the tile's centre.")
      .def_property_readonly("membranes", [](const VerificationReport& report) {
        return py::make_tuple(report.membrane[0], report.membrane[1]);
      });
  module.def(
      "verify_design",
      [](const Design& design, SolutionStore* store, py::object progress, bool weak_is_enough) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return verify_design(design, store, sink, {weak_is_enough});
        });
      },
      py::arg("design"), py::arg("store") = py::none(), py::arg("progress") = py::none(),
      py::arg("weak_is_enough") = false,
      "Membranes, contact forces and verdict. store: a SolutionStore that is asked for what is "
      "solved of the design already, and left with it. weak_is_enough: without a verdict where "
      "points "
      "push too weakly (complete is False).");
}

}  // namespace curveups::bindings
