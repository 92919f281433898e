// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/layout/layout.hpp"
#include "curveups/layout/soft_layout.hpp"

namespace curveups::bindings {
namespace {

// Flat corners and insets of a layout, with how it was found.
struct Layout {
  FlatCorners T;
  Array6 q;
  LayoutResult result;
};

}  // namespace

void bind_layout(py::module_& module) {
  py::class_<Layout>(module, "LayoutResult", "A layout and how it was found.")
      .def_property_readonly(
          "T", [](const Layout& r) { return to_blocks(r.T, 3, 2); }, "M x 3 x 2, mm.")
      .def_property_readonly(
          "q", [](const Layout& r) { return to_blocks(r.q, 2, 3); }, "M x 2 x 3, mm.")
      .def_property_readonly("converged",
                             [](const Layout& r) { return r.result.solve.converged(); })
      .def_property_readonly("stopped", [](const Layout& r) { return r.result.solve.stopped(); })
      .def_property_readonly("iterations",
                             [](const Layout& r) { return r.result.solve.iterations; })
      .def_property_readonly("collision_rounds",
                             [](const Layout& r) { return r.result.collision_rounds; })
      .def_property_readonly("separations", [](const Layout& r) { return r.result.separations; })
      .def_property_readonly("largest_violation_mm",
                             [](const Layout& r) { return r.result.solve.residual; })
      .def_property_readonly("energies", [](const Layout& r) { return r.result.energies; });
  module.def(
      "solve_layout",
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters,
         py::object progress) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          const DesignGeometry geometry = make_geometry({V, F}, cuts, parameters);
          Layout out;
          out.result = solve_layout(geometry, parameters, sink);
          out.T = flat_corners(geometry.tiles, out.result.poses);
          out.q = out.result.q;
          return out;
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(),
      "Flat poses and pins for a target mesh (Eq. 9 under hard constraints).");
  module.def(
      "solve_soft_layout",
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters,
         const std::optional<Design>& start, int max_iterations, py::object on_iterate) {
        Layout out;
        const TriangleMesh mesh{V, F};
        std::exception_ptr error;
        {
          py::gil_scoped_release release;
          const DesignGeometry geometry = make_geometry(mesh, cuts, parameters);
          std::optional<SoftLayoutStart> from;
          if (start) {
            if (start->mesh.F.rows() != F.rows()) {
              throw InvalidInput("the start has " + std::to_string(start->mesh.F.rows()) +
                                     " tiles, F has " + std::to_string(F.rows()),
                                 "start from a layout of the same mesh");
            }
            from = SoftLayoutStart{fit_poses(geometry.tiles, start->T), start->q};
          }
          const SoftLayoutCallback callback = [&](const FlatPoses& poses, const Array6& q,
                                                  double e) {
            py::gil_scoped_acquire acquire;
            try {
              if (on_iterate.is_none()) return true;
              const py::object answer = on_iterate(
                  to_blocks(flat_corners(geometry.tiles, poses), 3, 2), to_blocks(q, 2, 3), e);
              return answer.is_none() || answer.cast<bool>();
            } catch (...) {
              error = std::current_exception();
              return false;
            }
          };
          const LayoutResult soft =
              solve_soft_layout(geometry, parameters, from, max_iterations, callback);
          out.T = flat_corners(geometry.tiles, soft.poses);
          out.q = soft.q;
          out.result = soft;
        }
        if (error) std::rethrow_exception(error);
        return out;
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("start") = py::none(), py::arg("max_iterations") = 100,
      py::arg("on_iterate") = py::none(),
      "Eq. 9 with soft terms only, for interaction. on_iterate(T, q, energy) gets every accepted "
      "step and stops the work by returning False. start: a design of the same mesh.");
}

}  // namespace curveups::bindings
