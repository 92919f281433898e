// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation, its figures, and cuts that relieve it.
#include "curveups/bindings/arrays.hpp"
#include "curveups/layout/cut_suggestions.hpp"
#include "curveups/layout/diagnostics.hpp"
#include "curveups/layout/layout.hpp"

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

  py::class_<LayoutFigures>(module, "LayoutFigures", "How far a layout is stretched.")
      .def_readonly("scale_spread", &LayoutFigures::scale_spread)
      .def_readonly("area_ratio", &LayoutFigures::area_ratio)
      .def_readonly("energy_per_contact", &LayoutFigures::energy)
      .def_readonly("spring_mean", &LayoutFigures::spring_mean)
      .def_readonly("slack_springs", &LayoutFigures::slack_springs);
  module.def(
      "layout_figures",
      [](const Design& design) {
        const py::gil_scoped_release release;
        const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
        return layout_figures(geometry, design.parameters, fit_poses(geometry.tiles, design.T),
                              design.q);
      },
      py::arg("design"), "How far a design's layout is stretched.");

  py::class_<CutSuggestion>(module, "CutSuggestion", "A cut and what it does to the layout.")
      .def_readonly("edges", &CutSuggestion::edges)
      .def_readonly("length_mm", &CutSuggestion::length)
      .def_readonly("reasons", &CutSuggestion::reasons)
      .def_readonly("before", &CutSuggestion::before)
      .def_readonly("after", &CutSuggestion::after);
  py::class_<CutSuggestions>(module, "CutSuggestions", "Cuts in the order of their making.")
      .def_readonly("cuts", &CutSuggestions::cuts)
      .def_property_readonly("layouts", [](const CutSuggestions& s) { return s.solve.iterations; })
      .def_property_readonly("stopped", [](const CutSuggestions& s) { return s.solve.stopped(); });
  module.def(
      "suggest_cuts",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts, const Parameters& parameters,
         int most, const std::vector<std::array<int, 2>>& weak, py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        require_tiles(weak, mesh.F.rows(), "weak");
        return without_gil(std::move(progress), [&](const Progress& sink) {
          CutSuggestionOptions options;
          options.most = most;
          options.weak = weak;
          return suggest_cuts(mesh, edges, parameters, options, sink);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), py::arg("most"),
      py::arg("weak") = std::vector<std::array<int, 2>>(), py::arg("progress") = py::none(),
      "Cuts that let a target lie flat with less stretch. weak: tile pairs of weak contacts.");
}

}  // namespace curveups::bindings
