// SPDX-License-Identifier: LGPL-2.1-or-later
// The print model: figures, solids and files.
#include "curveups/bindings/bindings.hpp"
#include "curveups/bindings/part_shape.hpp"
#include "curveups/fabrication/print_session.hpp"

namespace curveups::bindings {

void bind_fabrication(py::module_& module) {
  py::class_<PrintSession>(
      module, "PrintModel",
      "All that is printed. Kinds: tiles, support, anchors, print (all) and actuated (the tiles in "
      "the target shape, without bumps). Lengths in mm, volumes in mm3.")
      .def_property_readonly("name", [](const PrintSession& s) { return s.model().name; })
      .def_property_readonly("piece_count",
                             [](const PrintSession& s) { return s.model().piece_count; })
      .def_property_readonly("tile_count",
                             [](const PrintSession& s) { return s.model().tiles.size(); })
      .def_property_readonly("body_count",
                             [](const PrintSession& s) { return s.bodies("print").size(); })
      .def_property_readonly(
          "bbox",
          [](const PrintSession& s) { return Vec3(s.model().box.high - s.model().box.low); })
      .def_property_readonly("volumes",
                             [](const PrintSession& s) {
                               py::dict out;
                               for (const char* kind : {"tiles", "support", "anchors"}) {
                                 out[kind] = s.volume(kind);
                               }
                               return out;
                             })
      .def_property_readonly(
          "thinnest",
          [](const PrintSession& s) {
            py::list out;
            for (const ThinFeature& thin : s.model().thin) {
              out.append(py::make_tuple(thin.body, thin.what, thin.size));
            }
            return out;
          },
          "Per body that has a size of its own: its name, its narrowest place and how wide that "
          "is.")
      .def_property_readonly(
          "bare_interfaces",
          [](const PrintSession& s) {
            py::list out;
            for (const BareInterface& bare : s.model().bumps.bare) {
              const Contact& contact = s.model().geometry.tiles.contacts[bare.contact];
              out.append(py::make_tuple(contact.tile[0], contact.tile[1], bare.reason));
            }
            return out;
          },
          "Contacts without bumps: their two tiles and why.")
      .def_property_readonly(
          "bump_tips",
          [](const PrintSession& s) {
            return bump_tips(s.model().geometry.tiles, s.model().bumps);
          },
          "Per contact the tips of its bumps, in the actuated configuration.")
      .def_property_readonly("loose_tiles",
                             [](const PrintSession& s) { return s.model().loose_tiles; })
      .def_property_readonly("loose_anchors",
                             [](const PrintSession& s) { return s.model().loose_anchors; })
      .def("min_clearance_flat",
           [](const PrintSession& s) {
             py::gil_scoped_release release;
             return min_clearance_flat(s.model()).value;
           })
      .def("max_overlap_actuated",
           [](const PrintSession& s) {
             py::gil_scoped_release release;
             return max_overlap_actuated(s.model()).value;
           })
      .def(
          "build_solids",
          [](PrintSession& s, py::object progress) {
            without_gil(std::move(progress), [&](const Progress& sink) {
              s.shape("print", sink);
              return true;
            });
          },
          py::arg("progress") = py::none(),
          "Builds all solids of the print; they are kept. Other calls do so when they need them.")
      .def(
          "check_solids",
          [](PrintSession& s, py::object progress) {
            const auto unsound = without_gil(std::move(progress),
                                             [&](const Progress& sink) { return s.check(sink); });
            py::list out;
            for (const UnsoundSolid& solid : unsound) {
              out.append(py::make_tuple(solid.body, solid.reason));
            }
            return out;
          },
          py::arg("progress") = py::none(),
          "Bodies whose solid is not valid, not closed or not of its exact volume, with the "
          "reason.")
      .def(
          "shape",
          [](PrintSession& s, const std::string& kind, bool direct, py::object progress) {
            const TopoDS_Shape shape = without_gil(
                std::move(progress), [&](const Progress& sink) { return s.shape(kind, sink); });
            return to_part_shape(shape, direct);
          },
          py::arg("kind"), py::arg("direct") = true, py::arg("progress") = py::none(),
          "A compound of the kind's solids as a Part.Shape. direct=False goes through a file.")
      .def(
          "write_step",
          [](PrintSession& s, const std::string& kind, const std::string& path,
             py::object progress) {
            without_gil(std::move(progress), [&](const Progress& sink) {
              s.write_step(kind, path, sink);
              return true;
            });
          },
          py::arg("kind"), py::arg("path"), py::arg("progress") = py::none())
      .def(
          "write_stl",
          [](const PrintSession& s, const std::string& kind, const std::string& path,
             py::object progress) {
            without_gil(std::move(progress), [&](const Progress& sink) {
              s.write_stl(kind, path, sink);
              return true;
            });
          },
          py::arg("kind"), py::arg("path"), py::arg("progress") = py::none())
      .def(
          "write_3mf",
          [](const PrintSession& s, const std::string& path, py::object progress) {
            without_gil(std::move(progress), [&](const Progress& sink) {
              s.write_3mf(path, sink);
              return true;
            });
          },
          py::arg("path"), py::arg("progress") = py::none());
  module.def(
      "make_print_model",
      [](const Design& design) {
        py::gil_scoped_release release;
        return PrintSession(design, CURVEUPS_VERSION);
      },
      py::arg("design"),
      "The print of a design; raises InfeasibleDesign, naming tiles, where it can't be made.");
  module.def(
      "bump_tips",
      [](const Design& design) {
        py::gil_scoped_release release;
        const DesignGeometry geometry = make_geometry(design.mesh, design.cuts, design.parameters);
        const FlatPoses poses = fit_poses(geometry.tiles, design.T);
        return bump_tips(geometry, poses, design.parameters);
      },
      py::arg("design"), "As PrintModel.bump_tips, without a print model.");
}

}  // namespace curveups::bindings
