// SPDX-License-Identifier: LGPL-2.1-or-later
// Figures per tile and per contact by name.
#include "curveups/bindings/arrays.hpp"
#include "curveups/layout/design_fields.hpp"
#include "curveups/layout/target_fields.hpp"

namespace curveups::bindings {

void bind_fields(py::module_& module) {
  module.def(
      "target_fields",
      [](const PointsIn& V, const TrianglesIn& F, const EdgesIn& cuts,
         const Parameters& parameters) {
        const TriangleMesh mesh = read_mesh(V, F);
        const Edges edges = read_edges(cuts, mesh.V.rows(), "cuts");
        const TargetFields fields = [&] {
          const py::gil_scoped_release release;
          return target_fields(mesh, edges, parameters);
        }();
        py::dict out;
        out["contact_tiles"] = fields.contacts;
        out["fold_angle"] = fields.fold;
        out["pin_room"] = fields.pin_room;
        out["conformal_stretch"] = fields.stretch;
        out["least_stretch"] = fields.least_stretch;
        out["most_stretch"] = fields.most_stretch;
        return out;
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      "What can be said before a layout. Per contact: contact_tiles (N x 2), fold_angle (degrees, "
      "convex positive). Per tile: pin_room (M x 2, front and back, mm2: the largest pin's area "
      "less A_pin_min), conformal_stretch (by how much the layout's start scales the tile's place; "
      "NaN where there is no flat map), least_stretch (below it the start leaves the tile less "
      "than d_gap_min, which a layout may make up for), most_stretch (above it the start has a "
      "slack membrane next to the tile).");
  module.def(
      "design_fields",
      [](const Design& design) {
        const DesignFields fields = [&] {
          const py::gil_scoped_release release;
          return design_fields(design);
        }();
        py::dict out;
        out["contact_tiles"] = fields.contacts;
        out["gap"] = fields.gap;
        out["membrane_slack"] = fields.membrane_slack;
        out["pin_area"] = fields.pin_area;
        out["spring_force"] = fields.spring_force;
        out["weak"] =
            py::array_t<int>(static_cast<py::ssize_t>(fields.weak.size()), fields.weak.data());
        return out;
      },
      py::arg("design"),
      "What can be said of a layout without its membranes. Per contact: contact_tiles (N x 2), gap "
      "(mm, flat), membrane_slack (N x 2, front and back: rest over actuated length; slack above "
      "1), spring_force (N, normal force as the springs of Eq. 16 predict it), weak (numbers "
      "of contacts whose spring_force is likely to be too small). Per tile: pin_area (M x "
      "2, "
      "front and back, mm2).");
}

}  // namespace curveups::bindings
