// SPDX-License-Identifier: LGPL-2.1-or-later
// The design and its file.
#include "curveups/bindings/arrays.hpp"
#include "curveups/design/design_arrays.hpp"
#include "curveups/design/design_file.hpp"

namespace curveups::bindings {

py::array_t<double> to_blocks(const Array6& m, int a, int b) {
  return py::array_t<double>({static_cast<py::ssize_t>(m.rows()), static_cast<py::ssize_t>(a),
                              static_cast<py::ssize_t>(b)},
                             m.data());
}

void bind_design(py::module_& module) {
  py::class_<Design>(module, "Design",
                     "A design, a value that does not change: parameters, V (N x 3), F (M x 3), T "
                     "(M x 3 x 2), q (M x 2 x 3), cuts (C x 2), target (V, F) or None. Lengths in "
                     "mm.")
      .def(py::init([](const std::string& name, const Parameters& parameters, const PointsIn& V,
                       const TrianglesIn& F, const BlocksIn& T, const BlocksIn& q,
                       const EdgesIn& cuts,
                       const std::optional<std::pair<PointsIn, TrianglesIn>>& target) {
             Design design{name,
                           parameters,
                           read_mesh(V, F),
                           read_blocks(T, "T", 3, 2),
                           read_blocks(q, "q", 2, 3),
                           {},
                           {}};
             design.cuts = read_edges(cuts, design.mesh.V.rows(), "cuts");
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
      .def_property_readonly("name", [](const Design& d) { return d.name; })
      .def_property_readonly(
          "parameters", [](const Design& d) { return d.parameters; }, "A copy.")
      .def_property_readonly("V", [](const Design& d) { return d.mesh.V; })
      .def_property_readonly("F", [](const Design& d) { return d.mesh.F; })
      .def_property_readonly("T", [](const Design& d) { return to_blocks(d.T, 3, 2); })
      .def_property_readonly("q", [](const Design& d) { return to_blocks(d.q, 2, 3); })
      .def_property_readonly("cuts", [](const Design& d) { return d.cuts; })
      .def_property_readonly("target", [](const Design& d) -> py::object {
        if (!d.target) return py::none();
        return py::make_tuple(d.target->V, d.target->F);
      });
  module.def("write_design", &write_design, py::arg("design"),
             py::call_guard<py::gil_scoped_release>(), "The text of design.json.");
  module.def("read_design", &read_design, py::arg("text"), py::call_guard<py::gil_scoped_release>(),
             "Reads the text of design.json; raises InvalidInput naming the field.");
}

}  // namespace curveups::bindings
