// SPDX-License-Identifier: LGPL-2.1-or-later
// Corners for what draws a design.
#include "curveups/bindings/arrays.hpp"
#include "curveups/design/tile_shapes.hpp"

namespace curveups::bindings {
namespace {

TileShapes shapes_at(const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts,
                     const Parameters& parameters, const std::optional<BlocksIn>& T,
                     const std::optional<BlocksIn>& q) {
  const TriangleMesh mesh = read_mesh(V, F);
  const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
  const FlatCorners corners = T ? read_blocks(*T, "T", 3, 2) : FlatCorners(0, 6);
  const Array6 insets = q ? read_blocks(*q, "q", 2, 3) : Array6(0, 6);
  const py::gil_scoped_release release;
  return tile_shapes(mesh, edges, parameters, corners, insets);
}

// Rows of numbers as blocks, without a copy: the array keeps its owner alive.
template <class Matrix>
py::array_t<double> blocks(const py::object& owner, const Matrix& m,
                           std::vector<py::ssize_t> shape) {
  shape.insert(shape.begin(), m.rows());
  py::array_t<double> out(shape, m.data(), owner);
  out.attr("setflags")(py::arg("write") = false);
  return out;
}

}  // namespace

void bind_tile_shapes(py::module_& module) {
  using Shapes = TileShapes;
  const auto corners = [](Shapes::Corners Shapes::*member) {
    return [member](const py::object& self) {
      return blocks(self, self.cast<const Shapes&>().*member, {6, 3});
    };
  };
  const auto pins = [](Shapes::Pins Shapes::*member) {
    return [member](const py::object& self) {
      return blocks(self, self.cast<const Shapes&>().*member, {2, 6, 3});
    };
  };
  py::class_<Shapes>(module, "TileShapes",
                     "Corners of tiles and pins, mm: of a tile the three front ones in the order "
                     "of F, then those below them; of a pin three at its foot, then three at its "
                     "end. Flat: front faces at z = 0. Tiles are not truncated.")
      .def_property_readonly("actuated", corners(&Shapes::actuated), "M x 6 x 3.")
      .def_property_readonly("flat", corners(&Shapes::flat), "M x 6 x 3; empty without T.")
      .def_property_readonly("actuated_pins", pins(&Shapes::actuated_pins),
                             "M x 2 x 6 x 3, front and back; empty without q.")
      .def_property_readonly("flat_pins", pins(&Shapes::flat_pins),
                             "M x 2 x 6 x 3; empty without T or q.")
      .def_readonly("contacts", &Shapes::contacts, "N x 2 tiles.")
      .def_readonly("contact_sides", &Shapes::contact_sides,
                    "N x 2, which edge (0 to 2) of each of the two tiles.")
      .def_property_readonly(
          "contact_edges",
          [](const py::object& self) {
            return blocks(self, self.cast<const Shapes&>().contact_edges, {2, 3});
          },
          "N x 2 x 3, the actuated front edge, as the first tile runs along it.");
  module.def(
      "tile_shapes",
      [](const Design& design) {
        const py::gil_scoped_release release;
        return tile_shapes(design.mesh, design.cuts, design.parameters, design.T, design.q);
      },
      py::arg("design"), "Corners of a design's tiles and pins in both configurations.");
  module.def("tile_shapes_at", &shapes_at, py::arg("V"), py::arg("F"), py::arg("cuts"),
             py::arg("parameters"), py::arg("T") = py::none(), py::arg("q") = py::none(),
             "The same of a target (actuated tiles alone) or of what a solver has at hand.");
}

}  // namespace curveups::bindings
