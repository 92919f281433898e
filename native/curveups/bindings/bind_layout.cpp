// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation, its figures, and cuts that relieve it.
#include <cmath>
#include <tuple>

#include "curveups/bindings/arrays.hpp"
#include "curveups/layout/cut_suggestions.hpp"
#include "curveups/layout/diagnostics.hpp"
#include "curveups/layout/layout.hpp"

namespace curveups::bindings {
namespace {

using EarlierIn = std::tuple<NumbersIn, NumbersIn, std::vector<int>>;  // T, q, a row of them a tile

std::optional<EarlierLayout> read_earlier(const std::optional<EarlierIn>& given,
                                          Eigen::Index tile_count) {
  if (!given) return std::nullopt;
  const auto& [T, q, from] = *given;
  const Array6 corners = read_blocks(T, "T", 3, 2), insets = read_blocks(q, "q", 2, 3);
  if (static_cast<Eigen::Index>(from.size()) != tile_count || corners.rows() != insets.rows()) {
    throw InvalidInput("earlier does not fit the tiles", "give a row for each tile");
  }
  EarlierLayout earlier{FlatCorners::Constant(tile_count, 6, std::nan("")),
                        Array6::Constant(tile_count, 6, std::nan(""))};
  for (Eigen::Index i = 0; i < tile_count; ++i) {
    if (from[i] < 0) continue;
    require_tiles(std::vector<int>{from[i]}, corners.rows(), "earlier");
    earlier.T.row(i) = corners.row(from[i]);
    earlier.q.row(i) = insets.row(from[i]);
  }
  return earlier;
}

LayoutResult lay_out(const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
                     const Parameters& parameters, const Progress& progress,
                     const std::optional<Listener>& on_iterate,
                     const std::optional<EarlierIn>& earlier) {
  const CutMesh target = read_cut_mesh(V, F, cuts);
  const std::optional<EarlierLayout> start = read_earlier(earlier, target.mesh.F.rows());
  const ProgressScope scope(progress);
  const DesignGeometry geometry = make_geometry(target.mesh, target.cuts, parameters);
  LayoutCallback callback;
  if (const auto listener = native_listener(on_iterate)) {
    callback = [listener, &geometry](const FlatPoses& poses, const Array6& q, double energy,
                                     double violation) {
      return listener(flat_corners(geometry.tiles, poses), q, energy, violation);
    };
  }
  return solve_layout(geometry, parameters, scope.sink(), LayoutEffort::full, callback,
                      start ? &*start : nullptr);
}

}  // namespace

void bind_layout(py::module_& module) {
  FiguresClass<LayoutResult>(module, "LayoutResult", "A layout and how it was found.")
      .figure("converged", [](const LayoutResult& r) { return r.solve.converged(); })
      .figure("iterations", [](const LayoutResult& r) { return r.solve.iterations; })
      .figure("collision_rounds", &LayoutResult::collision_rounds)
      .figure("separations", &LayoutResult::separations)
      .figure("largest_violation_mm", [](const LayoutResult& r) { return r.solve.residual; })
      .figure("energies", &LayoutResult::energies)
      .def_property_readonly("stopped", [](const LayoutResult& r) { return r.solve.stopped(); })
      .def_property_readonly(
          "T",
          [](const LayoutResult& r) {
            return to_blocks(r.T, {3, 2});
          },
          "M x 3 x 2, mm.")
      .def_property_readonly(
          "q",
          [](const LayoutResult& r) {
            return to_blocks(r.q, {2, 3});
          },
          "M x 2 x 3, mm.");
  module.def(
      "solve_layout", &lay_out, py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(), py::arg("on_iterate") = py::none(),
      py::arg("earlier") = py::none(), Released(),
      "Flat poses and pins for a target mesh (Eq. 9 under hard constraints). "
      "on_iterate(T, q, energy, violation) gets every iterate, the hard constraints' largest "
      "violation in mm with it, and stops the work by returning False. earlier: T and q to start "
      "from, and for each tile its row of them, -1 for new tiles.");

  FiguresClass<LayoutFigures>(module, "LayoutFigures", "How far a layout is stretched.")
      .figure("scale_spread", &LayoutFigures::scale_spread)
      .figure("area_ratio", &LayoutFigures::area_ratio)
      .figure("energy_per_contact", &LayoutFigures::energy)
      .figure("spring_mean", &LayoutFigures::spring_mean)
      .figure("slack_springs", &LayoutFigures::slack_springs);
  module.def(
      "layout_figures",
      [](const Design& design) {
        const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
        return layout_figures(geometry, design.parameters, fit_poses(geometry.tiles, design.T),
                              design.q);
      },
      Released(), py::arg("design"), "How far a design's layout is stretched.");

  py::class_<CutSuggestion>(module, "CutSuggestion", "A cut and its effect on draft layouts.")
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
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
         const Parameters& parameters, int most, const std::vector<std::array<int, 2>>& weak,
         const Progress& progress) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        require_tiles(weak, target.mesh.F.rows(), "weak");
        return suggest_cuts(target.mesh, target.cuts, parameters, {most, weak},
                            ProgressScope(progress).sink());
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), py::arg("most"),
      py::arg("weak") = std::vector<std::array<int, 2>>(), py::arg("progress") = py::none(),
      Released(),
      "Cuts that let a target lie flat with less stretch. weak: tile pairs of weak contacts.");
}

}  // namespace curveups::bindings
