// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters, the design with its file, and the checks of targets and constraints.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/constraints.hpp"
#include "curveups/design/design.hpp"
#include "curveups/design/design_file.hpp"
#include "curveups/design/target_checks.hpp"

namespace curveups::bindings {
namespace {

using ArrayNd = py::array_t<double, py::array::c_style | py::array::forcecast>;

const char* affects_name(Affects affects) {
  switch (affects) {
    case Affects::target:
      return "target";
    case Affects::layout:
      return "layout";
    case Affects::geometry:
      return "geometry";
    case Affects::files:
      return "files";
    case Affects::verification:
      return "verification";
  }
  return "";
}

py::object default_value(const ParameterInfo& info) {
  static const Parameters defaults;
  return std::visit([&](auto member) { return py::cast(defaults.*member); }, info.member);
}

// With the nearest known name, whatever its case, where one is like it.
[[noreturn]] void refuse_unknown(const std::string& name) {
  py::dict known;
  for (const ParameterInfo& info : parameter_table()) {
    const py::str given(info.name.data(), info.name.size());
    known[given.attr("lower")()] = given;
  }
  const py::list like = py::module_::import("difflib").attr("get_close_matches")(
      py::str(name).attr("lower")(), known, 1, 0.75);
  throw InvalidInput("unknown parameter '" + name + "'",
                     like.empty()
                         ? "list them with 'curveups parameters'"
                         : "did you mean '" + py::str(known[like[0]]).cast<std::string>() + "'?");
}

py::object value_of(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit([&](auto member) { return py::cast(parameters.*member); }, info.member);
}

Array6 from_blocks(const ArrayNd& array, const char* name, int a, int b) {
  if (array.ndim() != 3 || array.shape(1) != a || array.shape(2) != b) {
    throw InvalidInput(std::string(name) + " does not have the shape M x " + std::to_string(a) +
                           " x " + std::to_string(b),
                       "pass one block per tile");
  }
  return Eigen::Map<const Array6>(array.data(), array.shape(0), 6);
}

void require_rows(const Design& design, Eigen::Index rows, const char* name) {
  if (rows != design.mesh.F.rows()) {
    throw InvalidInput(std::string(name) + " has " + std::to_string(rows) + " rows, F has " +
                           std::to_string(design.mesh.F.rows()),
                       "pass one row per tile");
  }
}

}  // namespace

py::array_t<double> to_blocks(const Array6& m, int a, int b) {
  return py::array_t<double>({static_cast<py::ssize_t>(m.rows()), static_cast<py::ssize_t>(a),
                              static_cast<py::ssize_t>(b)},
                             m.data());
}

void bind_design(py::module_& module) {
  py::class_<ParameterInfo>(module, "ParameterInfo", "A row of the parameter table.")
      .def_property_readonly("name", [](const ParameterInfo& i) { return std::string(i.name); })
      .def_property_readonly("unit", [](const ParameterInfo& i) { return std::string(i.unit); })
      .def_property_readonly("group", [](const ParameterInfo& i) { return std::string(i.group); })
      .def_property_readonly("meaning",
                             [](const ParameterInfo& i) { return std::string(i.meaning); })
      .def_property_readonly("affects",
                             [](const ParameterInfo& i) { return affects_name(i.affects); })
      .def_property_readonly(
          "type",
          [](const ParameterInfo& i) {
            constexpr const char* names[] = {"number", "integer", "switch", "choice"};
            return i.member.index() == 3 && i.choices.empty() ? "tiles" : names[i.member.index()];
          })
      .def_property_readonly("default", &default_value)
      .def_readonly("minimum", &ParameterInfo::minimum)
      .def_readonly("maximum", &ParameterInfo::maximum)
      .def_property_readonly("choices", [](const ParameterInfo& i) {
        return std::vector<std::string>(i.choices.begin(), i.choices.end());
      });
  module.def("parameter_table", &parameter_table, py::return_value_policy::reference,
             "Every parameter, in the order in which they are shown.");

  py::class_<Parameters>(module, "Parameters", "The parameters of a design, at their defaults.")
      .def(py::init<>())
      .def(py::init<const Parameters&>())
      .def(
          "set",
          [](Parameters& p, const std::string& name, const py::object& value) {
            if (!find_parameter(name)) refuse_unknown(name);
            if (py::isinstance<py::bool_>(value)) {
              set_parameter(p, name, value.cast<bool>());
            } else if (py::isinstance<py::str>(value)) {
              set_parameter(p, name, value.cast<std::string>());
            } else if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
              set_parameter(p, name, value.cast<double>());
            } else {
              throw InvalidInput(
                  "parameter " + name + " can't be a " +
                      py::str(py::type::of(value).attr("__name__")).cast<std::string>(),
                  "give a number, a text or true or false");
            }
          },
          py::arg("name"), py::arg("value"), "Sets one parameter; raises InvalidInput.")
      .def(
          "get",
          [](const Parameters& p, const std::string& name) -> py::object {
            if (const ParameterInfo* info = find_parameter(name)) return value_of(p, *info);
            refuse_unknown(name);
          },
          py::arg("name"))
      .def("check", &check_parameters,
           "Raises InvalidInput for values that contradict one another.")
      .def("to_dict", [](const Parameters& p) {
        py::dict out;
        for (const ParameterInfo& info : parameter_table()) {
          out[py::str(std::string(info.name))] = value_of(p, info);
        }
        return out;
      });

  py::class_<Design>(module, "Design",
                     "A design: parameters, V (N x 3), F (M x 3), T (M x 3 x 2), q (M x 2 x 3), "
                     "cuts (C x 2), target (V, F) or None. Lengths in mm.")
      .def(py::init([](const std::string& name, const Parameters& parameters, const Points3& V,
                       const Triangles& F, const ArrayNd& T, const ArrayNd& q, const Edges& cuts) {
             Design design{
                 name, parameters, {V, F}, from_blocks(T, "T", 3, 2), from_blocks(q, "q", 2, 3),
                 cuts, {}};
             require_rows(design, design.T.rows(), "T");
             require_rows(design, design.q.rows(), "q");
             return design;
           }),
           py::arg("name"), py::arg("parameters"), py::arg("V"), py::arg("F"), py::arg("T"),
           py::arg("q"), py::arg("cuts"))
      .def_readwrite("name", &Design::name)
      .def_readwrite("parameters", &Design::parameters)
      .def_property_readonly("V", [](const Design& d) { return d.mesh.V; })
      .def_property_readonly("F", [](const Design& d) { return d.mesh.F; })
      .def_property_readonly("T", [](const Design& d) { return to_blocks(d.T, 3, 2); })
      .def_property_readonly("q", [](const Design& d) { return to_blocks(d.q, 2, 3); })
      .def_property_readonly("cuts", [](const Design& d) { return d.cuts; })
      .def_property_readonly("target",
                             [](const Design& d) -> py::object {
                               if (!d.target) return py::none();
                               return py::make_tuple(d.target->V, d.target->F);
                             })
      .def(
          "set_target",
          [](Design& d, const Points3& V, const Triangles& F) {
            d.target = TriangleMesh{V, F};
          },
          py::arg("V"), py::arg("F"), "The remeshed target, where V has moved away from it.");
  module.def("write_design", &write_design, py::arg("design"), "The text of design.json.");
  module.def("read_design", &read_design, py::arg("text"),
             "Reads the text of design.json; raises InvalidInput naming the field.");

  py::class_<TargetFinding>(
      module, "TargetFinding",
      "What can't work on a target, or may not: kind, message, remedy, tiles.")
      .def_readonly("kind", &TargetFinding::kind)
      .def_readonly("message", &TargetFinding::message)
      .def_readonly("remedy", &TargetFinding::remedy)
      .def_readonly("tiles", &TargetFinding::tiles)
      .def_readonly("is_error", &TargetFinding::is_error);
  module.def(
      "check_target",
      [](const Points3& V, const Triangles& F, const Edges& cuts, const Parameters& parameters) {
        py::gil_scoped_release release;
        return check_target({V, F}, cuts, parameters);
      },
      py::arg("V"), py::arg("F"), py::arg("cuts"), py::arg("parameters"),
      "What tiles of this thickness and these pins can't do on a remeshed target.");

  py::class_<ConstraintReport>(module, "ConstraintReport")
      .def_readonly("max_rigidity_mm", &ConstraintReport::max_rigidity_mm)
      .def_readonly("max_gap_violation_mm", &ConstraintReport::max_gap_violation_mm)
      .def_readonly("max_pin_bound_violation_mm", &ConstraintReport::max_pin_bound_violation_mm)
      .def_readonly("max_pin_area_violation_mm2", &ConstraintReport::max_pin_area_violation_mm2)
      .def_readonly("close_pairs", &ConstraintReport::close_pairs)
      .def_property_readonly("small_pins", [](const ConstraintReport& report) {
        py::list out;
        for (const SmallPin& pin : report.small_pins) {
          out.append(
              py::make_tuple(pin.tile, pin.side == Side::front ? "front" : "back", pin.area));
        }
        return out;
      });

  py::class_<DesignFigures>(module, "DesignFigures", "Counts and areas of a design.")
      .def_readonly("contacts", &DesignFigures::contacts)
      .def_readonly("hinges", &DesignFigures::hinges)
      .def_readonly("three_point_contacts", &DesignFigures::three_point_contacts)
      .def_readonly("truncation_types", &DesignFigures::truncation_types)
      .def_readonly("unresolved", &DesignFigures::unresolved)
      .def_readonly("actuated_area_mm2", &DesignFigures::actuated_area)
      .def_readonly("flat_area_mm2", &DesignFigures::flat_area)
      .def_readonly("constraints", &DesignFigures::constraints);
  module.def(
      "evaluate_design",
      [](const Design& design) {
        py::gil_scoped_release release;
        return evaluate_design(design);
      },
      py::arg("design"),
      "Counts, areas and how well the hard constraints hold, from the design alone. Raises "
      "InfeasibleDesign where its tiles can't be made.");
}

}  // namespace curveups::bindings
