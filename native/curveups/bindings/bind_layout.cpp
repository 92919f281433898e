// SPDX-License-Identifier: LGPL-2.1-or-later
// The coarse optimisation.
#include "curveups/bindings/bindings.hpp"
#include "curveups/layout/layout.hpp"

namespace curveups::bindings {
namespace {

struct LayoutDesign {
  Design design;
  LayoutResult result;
};

}  // namespace

void bind_layout(py::module_& module) {
  py::class_<LayoutDesign>(module, "LayoutResult", "A design and how its layout was found.")
      .def_readonly("design", &LayoutDesign::design)
      .def_property_readonly("converged", [](const LayoutDesign& r) { return r.result.converged; })
      .def_property_readonly("stopped", [](const LayoutDesign& r) { return r.result.stopped; })
      .def_property_readonly("iterations",
                             [](const LayoutDesign& r) { return r.result.iterations; })
      .def_property_readonly("collision_rounds",
                             [](const LayoutDesign& r) { return r.result.collision_rounds; })
      .def_property_readonly("separations",
                             [](const LayoutDesign& r) { return r.result.separations; })
      .def_property_readonly("largest_violation_mm",
                             [](const LayoutDesign& r) { return r.result.largest_violation; })
      .def_property_readonly("energies", [](const LayoutDesign& r) { return r.result.energies; });
  module.def(
      "solve_layout",
      [](const std::string& name, const Points3& V, const Triangles& F, const Edges& cuts,
         const Parameters& parameters, py::object progress) {
        return without_gil(std::move(progress), [&](const Progress& sink) {
          LayoutDesign out;
          const TriangleMesh mesh{V, F};
          const DesignGeometry geometry = make_geometry(mesh, cuts, parameters);
          out.result = solve_layout(geometry, parameters, sink);
          out.design = {
              name,         parameters, mesh, flat_corners(geometry.tiles, out.result.poses),
              out.result.q, cuts,       {}};
          return out;
        });
      },
      py::arg("name"), py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      py::arg("progress") = py::none(),
      "Flat poses and pins for a target mesh (Eq. 9 under hard constraints).");
}

}  // namespace curveups::bindings
