// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/arrays.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/divide_surface.hpp"

namespace curveups::bindings {

void bind_divide_surface(py::module_& module) {
  py::class_<SurfaceDivision>(module, "SurfaceDivision", "A surface in pieces that can lie flat.")
      .def_property_readonly("piece",
                             [](const SurfaceDivision& d) { return py::array(py::cast(d.piece)); })
      .def_readonly("borders", &SurfaceDivision::borders)
      .def_readonly("slits", &SurfaceDivision::slits);
  module.def(
      "divide_surface",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts, int count,
         py::object progress) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        return without_gil(std::move(progress), [&](const Progress&) {
          checkpoint("dividing into pieces");
          const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
          return divide_surface(mesh, topology, mark_cuts(topology, edges), count);
        });
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("count"),
      py::arg("progress") = py::none(),
      "Divides a mesh that is cut along `cuts` into `count` pieces: the piece of each face, the "
      "edges "
      "between pieces, and the slits inside of them that let each lie flat.");
  module.def(
      "pieces_of_faces",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
        return py::array(py::cast(pieces_of_faces(topology, mark_cuts(topology, edges))));
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"),
      "The piece of each face of a mesh that is cut along `cuts`, from 0 in the order of the "
      "lowest faces.");
}

}  // namespace curveups::bindings
