// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/bindings/bindings.hpp"
#include "curveups/layout/layout_figures.hpp"

namespace curveups::bindings {

void bind_layout_figures(py::module_& module) {
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
}

}  // namespace curveups::bindings
