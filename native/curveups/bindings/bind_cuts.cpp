// SPDX-License-Identifier: LGPL-2.1-or-later
// What helps a design that is stretched too far or stays invalid: cuts, other parameters.
#include "curveups/bindings/bindings.hpp"
#include "curveups/layout/cut_suggestions.hpp"
#include "curveups/layout/remedies.hpp"

namespace curveups::bindings {

void bind_cuts(py::module_& module) {
  py::class_<LayoutFigures>(module, "LayoutFigures", "How far a layout is stretched.")
      .def_readonly("scale_spread", &LayoutFigures::scale_spread)
      .def_readonly("area_ratio", &LayoutFigures::area_ratio)
      .def_readonly("energy_per_contact", &LayoutFigures::energy)
      .def_readonly("spring_mean", &LayoutFigures::spring_mean)
      .def_readonly("slack_springs", &LayoutFigures::slack_springs);
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
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters,
         int most, const std::vector<std::array<int, 2>>& weak, py::object progress) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          CutSuggestionOptions options;
          options.most = most;
          options.weak = weak;
          return suggest_cuts({V, F}, cuts, parameters, options, sink);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), py::arg("most"),
      py::arg("weak") = std::vector<std::array<int, 2>>(), py::arg("progress") = py::none(),
      "Cuts that let a target lie flat with less stretch. weak: tile pairs of weak contacts.");
  module.def(
      "layout_figures",
      [](const Design& design) {
        const py::gil_scoped_release release;
        const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
        return layout_figures(geometry, design.parameters, fit_poses(geometry.tiles, design.T),
                              design.q);
      },
      py::arg("design"), "How far a design's layout is stretched.");
  py::class_<Remedies>(module, "Remedies", "Parameter values that would help weak contacts.")
      .def_readonly("H_body", &Remedies::H_body)
      .def_readonly("L", &Remedies::L)
      .def_readonly("tau", &Remedies::tau);
  module.def(
      "find_remedies",
      [](const Design& design, const std::vector<int>& pins,
         const std::vector<std::array<int, 2>>& weak) {
        const py::gil_scoped_release release;
        return find_remedies(design, pins, weak);
      },
      py::arg("design"), py::arg("pins"), py::arg("weak"),
      "Other values of H_body, L and tau: for pins of the tiles `pins` that want room, and "
      "contacts of the tile pairs `weak`.");
}

}  // namespace curveups::bindings
