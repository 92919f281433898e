// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/refinement/fairing.hpp"

namespace curveups::bindings {

void bind_fairing(py::module_& module) {
  py::class_<FairedSurface>(module, "FairedSurface", "Vertices moved so that tiles are possible.")
      .def_property_readonly("V", [](const FairedSurface& s) { return s.mesh.V; })
      .def_readonly("move", &FairedSurface::move, "of each vertex, mm")
      .def_readonly("fixed", &FairedSurface::fixed)
      .def_readonly("remaining", &FairedSurface::remaining)
      .def_readonly("overlapping", &FairedSurface::overlapping)
      .def_readonly("steps", &FairedSurface::steps);
  module.def(
      "fair_surface",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts, const EdgesIn& kept,
         double largest_move, const Parameters& parameters, py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        const Edges lines = read_edges(kept, mesh.V.rows(), "kept");
        return without_gil(std::move(progress), [&](const Progress& sink) {
          return fair_surface(mesh, edges, lines, largest_move, parameters, sink);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("kept"), py::arg("largest_move"),
      py::arg("parameters"), py::arg("progress") = py::none(),
      "Moves vertices until every tile has a back face and room for its pins.");
}

}  // namespace curveups::bindings
