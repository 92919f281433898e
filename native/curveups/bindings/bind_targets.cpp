// SPDX-License-Identifier: LGPL-2.1-or-later
// Margins of tiles on a remeshed target, and smoothing that gives tiles room.
#include "curveups/bindings/arrays.hpp"
#include "curveups/bodies/facing_pins.hpp"
#include "curveups/layout/diagnostics.hpp"
#include "curveups/refinement/pin_smoothing.hpp"
#include "curveups/refinement/target_smoothing.hpp"

namespace curveups::bindings {

void bind_targets(py::module_& module) {
  module.def(
      "check_target",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
         const Parameters& parameters) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        return check_target(target.mesh, target.cuts, parameters);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), Released(),
      "Obstacles and warnings of a remeshed target for tiles of this thickness and these pins.");

  using Figures = TargetFigures;
  py::class_<Figures>(module, "TargetFigures", "Margins of a target's tiles (M) and contacts (N).")
      .def_readonly("contacts", &Figures::contacts, "N x 2 tiles.")
      .def_readonly("dihedral", &Figures::dihedral, "N, degrees, convex positive.")
      .def_readonly("dihedral_margin", &Figures::dihedral_margin,
                    "N, degrees by which the fold could grow before a back face vanishes.")
      .def_readonly("back_scale", &Figures::back_scale,
                    "M, length of the back face over that of the front face.")
      .def_readonly("pin_area", &Figures::pin_area,
                    "M x 2, front and back, mm2: of the largest pin there.")
      .def_readonly("stretch", &Figures::stretch,
                    "M, by how much the layout's start scales the tile's place; NaN: no flat map.")
      .def_readonly("least_stretch", &Figures::least_stretch,
                    "M, below it the start leaves the tile less than d_gap_min.")
      .def_readonly("most_stretch", &Figures::most_stretch,
                    "M, above it the start has a slack membrane next to the tile.")
      .def_readonly("shaped", &Figures::shaped,
                    "True where every tile has a back face; the next ones are empty otherwise.")
      .def_readonly("interface_share", &Figures::interface_share,
                    "N, the interface's back edge over its front edge; 0: a hinge.")
      .def_readonly("membrane_clearance", &Figures::membrane_clearance,
                    "M x 2, front and back, mm: how far pins' tops stand over the tile's corners "
                    "and contacts; negative: a membrane cuts into it.")
      .def_readonly("trimmed", &Figures::trimmed,
                    "Pairs of tiles without a common vertex that a plane cuts off.")
      .def_readonly("overlapping", &Figures::overlapping, "Pairs that no plane parts.");
  module.def(
      "target_figures",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
         const Parameters& parameters) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        return target_figures(target.mesh, target.cuts, parameters);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), Released(),
      "Margins of every tile and contact before it can't be made.");
  module.def(
      "facing_pins",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts, Parameters parameters) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        parameters.held_tiles.clear();  // tiles of the design, not of a mesh on trial
        return facing_pins(make_geometry(target.mesh, target.cuts, parameters), parameters.H_pin);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"), Released(),
      "Pairs of tiles without a common vertex of which a pin of one would run into the other. "
      "Raises "
      "InfeasibleDesign where tiles have no back face.");

  py::class_<PinSmoothing>(module, "PinSmoothing", "Vertices moved so that pins have room.")
      .def_property_readonly("V", [](const PinSmoothing& r) { return r.mesh.V; })
      .def_readonly("largest_move_mm", &PinSmoothing::largest_move)
      .def_readonly("reached", &PinSmoothing::reached)
      .def_readonly("remaining", &PinSmoothing::remaining);
  module.def(
      "smooth_for_pins",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
         const Parameters& parameters, const Progress& progress) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        return smooth_for_pins(target.mesh, target.cuts, parameters,
                               ProgressScope(progress).sink());
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(), Released(),
      "Moves vertices a little where folds leave pin sides less than A_pin_min.");

  py::class_<SmoothedTarget>(module, "FairedSurface", "Vertices moved so that tiles are possible.")
      .def_property_readonly("V", [](const SmoothedTarget& s) { return s.mesh.V; })
      .def_readonly("move", &SmoothedTarget::move, "Of each vertex, mm.")
      .def_readonly("fixed", &SmoothedTarget::fixed)
      .def_readonly("remaining", &SmoothedTarget::remaining)
      .def_readonly("overlapping", &SmoothedTarget::overlapping)
      .def_readonly("steps", &SmoothedTarget::steps);
  module.def(
      "smooth_target",
      [](const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts, const IndicesIn& kept,
         double largest_move, const Parameters& parameters, const Progress& progress) {
        const CutMesh target = read_cut_mesh(V, F, cuts);
        const Edges lines = read_edges(kept, target.mesh.V.rows(), "kept");
        return smooth_target(target.mesh, target.cuts, lines, largest_move, parameters,
                             ProgressScope(progress).sink());
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("kept"), py::arg("largest_move"),
      py::arg("parameters"), py::arg("progress") = py::none(), Released(),
      "Moves vertices until every tile has a back face and room for its pins.");
}

}  // namespace curveups::bindings
