// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation.
#include "curveups/bindings/arrays.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/layout/layout.hpp"
#include "curveups/layout/soft_layout.hpp"

namespace curveups::bindings {
namespace {

LayoutCallback by_corners(const PythonListener::Function& listener, const TileMesh& tiles) {
  if (!listener) return {};
  return [&listener, &tiles](const FlatPoses& poses, const Array6& q, double energy,
                             double violation) {
    return listener(flat_corners(tiles, poses), q, energy, violation);
  };
}

LayoutResult lay_out(const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts,
                     const Parameters& parameters, py::object progress, py::object on_iterate) {
  const TriangleMesh mesh = read_mesh(V, F);
  const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
  PythonListener listener(std::move(on_iterate));
  const PythonListener::Function function = listener.function();
  LayoutResult result = without_gil(std::move(progress), [&](const Progress& sink) {
    const DesignGeometry geometry = make_geometry(mesh, edges, parameters);
    return solve_layout(geometry, parameters, sink, LayoutEffort::full,
                        by_corners(function, geometry.tiles));
  });
  listener.rethrow();
  return result;
}

LayoutResult lay_out_softly(const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts,
                            const Parameters& parameters, const std::optional<Design>& start,
                            int max_iterations, py::object progress, py::object on_iterate) {
  const TriangleMesh mesh = read_mesh(V, F);
  const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
  if (start && start->mesh.F.rows() != mesh.F.rows()) {
    throw InvalidInput("the start has " + std::to_string(start->mesh.F.rows()) + " tiles, F has " +
                           std::to_string(mesh.F.rows()),
                       "start from a layout of the same mesh");
  }
  PythonListener listener(std::move(on_iterate));
  const PythonListener::Function function = listener.function();
  LayoutResult result = without_gil(std::move(progress), [&](const Progress& sink) {
    const DesignGeometry geometry = make_geometry(mesh, edges, parameters);
    std::optional<SoftLayoutStart> from;
    if (start) from = SoftLayoutStart{fit_poses(geometry.tiles, start->T), start->q};
    return solve_soft_layout(geometry, parameters, from, max_iterations, sink,
                             by_corners(function, geometry.tiles));
  });
  listener.rethrow();
  return result;
}

}  // namespace

void bind_layout(py::module_& module) {
  py::class_<LayoutResult>(module, "LayoutResult", "A layout and how it was found.")
      .def_property_readonly(
          "T", [](const LayoutResult& r) { return to_blocks(r.T, 3, 2); }, "M x 3 x 2, mm.")
      .def_property_readonly(
          "q", [](const LayoutResult& r) { return to_blocks(r.q, 2, 3); }, "M x 2 x 3, mm.")
      .def_property_readonly("converged", [](const LayoutResult& r) { return r.solve.converged(); })
      .def_property_readonly("stopped", [](const LayoutResult& r) { return r.solve.stopped(); })
      .def_property_readonly("iterations", [](const LayoutResult& r) { return r.solve.iterations; })
      .def_readonly("collision_rounds", &LayoutResult::collision_rounds)
      .def_readonly("separations", &LayoutResult::separations)
      .def_property_readonly("largest_violation_mm",
                             [](const LayoutResult& r) { return r.solve.residual; })
      .def_readonly("energies", &LayoutResult::energies);
  module.def(
      "solve_layout", &lay_out, py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(), py::arg("on_iterate") = py::none(),
      "Flat poses and pins for a target mesh (Eq. 9 under hard constraints). "
      "on_iterate(T, q, energy, violation) gets every iterate, the hard constraints' largest "
      "violation in mm with it, and stops the work by returning False.");
  module.def("solve_soft_layout", &lay_out_softly, py::arg("V"), py::arg("F"), py::arg("cuts"),
             py::arg("parameters"), py::arg("start") = py::none(), py::arg("max_iterations") = 100,
             py::arg("progress") = py::none(), py::arg("on_iterate") = py::none(),
             "Eq. 9 with soft terms only, for interaction; on_iterate as in solve_layout. start: a "
             "design of the same mesh.");
}

}  // namespace curveups::bindings
