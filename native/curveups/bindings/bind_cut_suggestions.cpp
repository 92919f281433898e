// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/layout/cut_suggestions.hpp"

namespace curveups::bindings {

void bind_cut_suggestions(py::module_& module) {
  py::class_<CutSuggestion>(module, "CutSuggestion", "A cut and what it does to the layout.")
      .def_readonly("edges", &CutSuggestion::edges)
      .def_readonly("length_mm", &CutSuggestion::length)
      .def_readonly("reason", &CutSuggestion::reason)
      .def_readonly("opens", &CutSuggestion::opens)
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
