// SPDX-License-Identifier: LGPL-2.1-or-later
// A design, how well it keeps its constraints, and the corners of its tiles.
#include "curveups/bindings/arrays.hpp"
#include "curveups/design/design_file.hpp"
#include "curveups/design/tile_shapes.hpp"
#include "curveups/layout/diagnostics.hpp"

namespace curveups::bindings {
namespace {

TileShapes shapes_at(const NumbersIn& V, const IndicesIn& F, const IndicesIn& cuts,
                     const Parameters& parameters, const std::optional<NumbersIn>& T,
                     const std::optional<NumbersIn>& q) {
  const CutMesh target = read_cut_mesh(V, F, cuts);
  const FlatCorners corners = T ? read_blocks(*T, "T", 3, 2) : FlatCorners(0, 6);
  const Array6 insets = q ? read_blocks(*q, "q", 2, 3) : Array6(0, 6);
  return tile_shapes(target.mesh, target.cuts, parameters, corners, insets);
}

// As report.json has it.
py::dict bound_block(const RelaxedBound& bound) {
  py::dict out;
  out["what"] = bound.what;
  out["tile"] = bound.tile;
  out["side"] = side_name(bound.side);
  out["edge"] = bound.edge;
  out["from"] = bound.from;
  out["to"] = bound.to;
  return out;
}

}  // namespace

void bind_design(py::module_& module) {
  py::class_<Design>(module, "Design",
                     "A design, a value that does not change: parameters, V (N x 3), F (M x 3), T "
                     "(M x 3 x 2), q (M x 2 x 3), cuts (C x 2), target (V, F) or None. Lengths in "
                     "mm.")
      .def(py::init([](const std::string& name, const Parameters& parameters, const NumbersIn& V,
                       const IndicesIn& F, const NumbersIn& T, const NumbersIn& q,
                       const IndicesIn& cuts,
                       const std::optional<std::pair<NumbersIn, IndicesIn>>& target) {
             CutMesh actuated = read_cut_mesh(V, F, cuts);
             Design design{name,
                           parameters,
                           std::move(actuated.mesh),
                           read_blocks(T, "T", 3, 2),
                           read_blocks(q, "q", 2, 3),
                           std::move(actuated.cuts),
                           {}};
             if (target) {
               design.target = read_mesh(target->first, target->second, "target V", "target F");
             }
             require_fitting_arrays(design);
             return design;
           }),
           py::arg("name"), py::arg("parameters"), py::arg("V"), py::arg("F"), py::arg("T"),
           py::arg("q"), py::arg("cuts"), py::arg("target") = py::none(),
           "target: the remeshed target, where V has moved away from it.")
      .def(
          "with_parameters",
          [](Design d, const Parameters& parameters) {
            d.parameters = parameters;
            return d;
          },
          py::arg("parameters"), "The same arrays under other parameters.")
      .def(
          "with_name",
          [](Design d, const std::string& name) {
            d.name = name;
            return d;
          },
          py::arg("name"))
      .def_readonly("name", &Design::name)
      .def_property_readonly(
          "parameters", [](const Design& d) { return d.parameters; }, "A copy.")
      .def_property_readonly("V", [](const Design& d) { return d.mesh.V; })
      .def_property_readonly("F", [](const Design& d) { return d.mesh.F; })
      .def_property_readonly("T",
                             [](const Design& d) {
                               return to_blocks(d.T, {3, 2});
                             })
      .def_property_readonly("q",
                             [](const Design& d) {
                               return to_blocks(d.q, {2, 3});
                             })
      .def_property_readonly("cuts", [](const Design& d) { return d.cuts; })
      .def_property_readonly("target", [](const Design& d) -> py::object {
        if (!d.target) return py::none();
        return py::make_tuple(d.target->V, d.target->F);
      });
  module.def("write_design", &write_design, py::arg("design"), Released(),
             "The text of design.json.");
  module.def("read_design", &read_design, py::arg("text"), Released(),
             "Reads the text of design.json; raises InvalidInput naming the field.");

  py::class_<SmallPin>(module, "SmallPin", "A pin side of less than A_pin_min.")
      .def_readonly("tile", &SmallPin::tile)
      .def_property_readonly("side", [](const SmallPin& pin) { return side_name(pin.side); })
      .def_readonly("area", &SmallPin::area, "mm2");
  using Report = ConstraintReport;
  FiguresClass<Report>(module, "ConstraintReport", "How well a design keeps its constraints.")
      .figure("max_rigidity_mm", &Report::max_rigidity_mm)
      .figure("max_gap_violation_mm", &Report::max_gap_violation_mm)
      .figure("max_pin_bound_violation_mm", &Report::max_pin_bound_violation_mm)
      .figure("max_pin_area_violation_mm2", &Report::max_pin_area_violation_mm2)
      .figure("pin_sides_below_area", [](const Report& report) { return report.small_pins.size(); })
      .figure("overlaps", [](const Report& report) { return report.close_pairs.size(); })
      .def_readonly("small_pins", &Report::small_pins)
      .def_property_readonly(
          "relaxed",
          [](const Report& report) {
            py::list out;
            for (const RelaxedBound& bound : report.relaxed) out.append(bound_block(bound));
            return out;
          },
          "Bounds of insets that gave way to folds, mm; the violation is measured against `to`.");

  py::class_<DesignFigures>(module, "DesignFigures", "Counts and areas of a design.")
      .def_readonly("contacts", &DesignFigures::contacts, "N x 2 tiles.")
      .def_readonly("gap", &DesignFigures::gap, "N, mm, flat.")
      .def_readonly("pin_area", &DesignFigures::pin_area, "M x 2, front and back, mm2.")
      .def_readonly("hinges", &DesignFigures::hinges)
      .def_readonly("three_point_contacts", &DesignFigures::three_point_contacts)
      .def_readonly("truncation_types", &DesignFigures::truncation_types)
      .def_readonly("shortened", &DesignFigures::shortened,
                    "Pairs without a common vertex that were parted at the cost of an interface.")
      .def_readonly("flat_clearance_mm", &DesignFigures::flat_clearance,
                    "Part of d_gap_min that bumps leave between flat tiles.")
      .def_readonly("actuated_area_mm2", &DesignFigures::actuated_area)
      .def_readonly("flat_area_mm2", &DesignFigures::flat_area)
      .def_readonly("constraints", &DesignFigures::constraints)
      .def_readonly("reasons", &DesignFigures::reasons,
                    "Reasons for which the design is not valid; none: these figures hold.");
  module.def("evaluate_design", &evaluate_design, py::arg("design"), Released(),
             "Counts, areas and how well the hard constraints hold, from the design alone. Raises "
             "InfeasibleDesign where its tiles can't be made.");

  using Shapes = TileShapes;
  py::class_<Shapes>(module, "TileShapes",
                     "Corners of tiles and pins, mm: of a tile the three front ones in the order "
                     "of F, then those below them; of a pin three at its foot, then three at its "
                     "end. Flat: front faces at z = 0. Tiles are not truncated.")
      .def_property_readonly(
          "actuated",
          [](const Shapes& s) {
            return to_blocks(s.actuated, {6, 3});
          },
          "M x 6 x 3.")
      .def_property_readonly(
          "flat",
          [](const Shapes& s) {
            return to_blocks(s.flat, {6, 3});
          },
          "M x 6 x 3; empty without T.")
      .def_property_readonly(
          "actuated_pins",
          [](const Shapes& s) {
            return to_blocks(s.actuated_pins, {2, 6, 3});
          },
          "M x 2 x 6 x 3, front and back; empty without q.")
      .def_property_readonly(
          "flat_pins",
          [](const Shapes& s) {
            return to_blocks(s.flat_pins, {2, 6, 3});
          },
          "M x 2 x 6 x 3; empty without T or q.")
      .def_readonly("contacts", &Shapes::contacts, "N x 2 tiles.")
      .def_readonly("contact_sides", &Shapes::contact_sides,
                    "N x 2, which edge (0 to 2) of each of the two tiles.");
  module.def(
      "tile_shapes",
      [](const Design& design) {
        return tile_shapes(design.mesh, design.cuts, design.parameters, design.T, design.q);
      },
      py::arg("design"), Released(),
      "Corners of a design's tiles and pins in both configurations.");
  module.def("tile_shapes_at", &shapes_at, py::arg("V"), py::arg("F"), py::arg("cuts"),
             py::arg("parameters"), py::arg("T") = py::none(), py::arg("q") = py::none(),
             Released(), "The same for a target (actuated tiles alone) or an iterate of a solver.");
}

}  // namespace curveups::bindings
