// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters and their table.
#include "curveups/bindings/bindings.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/parameters.hpp"

namespace curveups::bindings {
namespace {

py::object value_of(const Parameters& parameters, const ParameterInfo& info) {
  return std::visit([&](auto member) { return py::cast(parameters.*member); }, info.member);
}

py::object default_value(const ParameterInfo& info) {
  static const Parameters defaults;
  return value_of(defaults, info);
}

std::vector<std::string> readers(const ParameterInfo& info) {
  std::vector<std::string> names;
  for (std::size_t part = 0; part < reader::names.size(); ++part) {
    if (info.readers & (1u << part)) names.emplace_back(reader::names[part]);
  }
  return names;
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

}  // namespace

void bind_parameters(py::module_& module) {
  py::class_<ParameterInfo>(module, "ParameterInfo", "A row of the parameter table.")
      .def_property_readonly("name", [](const ParameterInfo& i) { return std::string(i.name); })
      .def_property_readonly("unit", [](const ParameterInfo& i) { return std::string(i.unit); })
      .def_property_readonly("group", [](const ParameterInfo& i) { return std::string(i.group); })
      .def_property_readonly("meaning",
                             [](const ParameterInfo& i) { return std::string(i.meaning); })
      .def_property_readonly(
          "tier", [](const ParameterInfo& i) { return std::string(tier(i)); },
          "What follows a change: layout, rebuild, verify or files.")
      .def_property_readonly("readers", &readers, "Parts of the engine that read it.")
      .def_property_readonly(
          "type",
          [](const ParameterInfo& i) {
            constexpr const char* names[] = {"number", "integer", "switch", "choice"};
            return std::string(i.text.empty() ? names[i.member.index()] : i.text);
          })
      .def_property_readonly("default", &default_value)
      .def_readonly("minimum", &ParameterInfo::minimum)
      .def_readonly("maximum", &ParameterInfo::maximum)
      .def_property_readonly("choices", [](const ParameterInfo& i) {
        return std::vector<std::string>(i.choices.begin(), i.choices.end());
      });
  module.def("parameter_table", &parameter_table, py::return_value_policy::reference,
             "Every parameter, in the order in which they are shown.");

  module.def("retired_parameters", &retired_parameters,
             "Names of parameters that earlier versions had: setting one has no effect.");
  module.def("find_parameter", &find_parameter, py::return_value_policy::reference, py::arg("name"),
             "The row of a parameter by its name or an alias; None for an unknown name.");

  py::class_<Parameters>(module, "Parameters", "The parameters of a design, at their defaults.")
      .def(py::init<>())
      .def(py::init<const Parameters&>())
      .def(
          "set",
          [](Parameters& p, const std::string& name, const py::object& value) {
            if (!find_parameter(name) && !is_retired(name)) refuse_unknown(name);
            if (py::isinstance<py::bool_>(value)) {
              set_parameter(p, name, value.cast<bool>());
            } else if (py::isinstance<py::str>(value)) {
              set_parameter(p, name, value.cast<std::string>());
            } else if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value)) {
              const double number = PyFloat_AsDouble(value.ptr());
              if (PyErr_Occurred()) {  // an integer beyond all numbers
                PyErr_Clear();
                throw InvalidInput("parameter " + name + " can't have this value",
                                   "give one within the range that 'curveups parameters' says");
              }
              set_parameter(p, name, number);
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
}

}  // namespace curveups::bindings
