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

std::vector<std::string> readers(const ParameterInfo& info) {
  std::vector<std::string> names;
  for (std::size_t part = 0; part < reader::names.size(); ++part) {
    if (info.readers & (1u << part)) names.emplace_back(reader::names[part]);
  }
  return names;
}

py::dict row_of(const ParameterInfo& info) {
  static const Parameters defaults;
  constexpr const char* types[] = {"number", "switch", "choice"};
  py::dict row;
  row["name"] = std::string(info.name);
  row["unit"] = std::string(info.unit);
  row["group"] = std::string(info.group);
  row["meaning"] = std::string(info.meaning);
  row["readers"] = readers(info);
  row["type"] = std::string(info.text.empty() ? types[info.member.index()] : info.text);
  row["default"] = value_of(defaults, info);
  row["minimum"] = info.minimum;
  row["maximum"] = info.maximum;
  row["choices"] = std::vector<std::string>(info.choices.begin(), info.choices.end());
  row["basic"] = (info.traits & trait::basic) != 0;
  row["keeps_layout"] = (info.traits & trait::keeps_layout) != 0;
  return row;
}

// Names the nearest known parameter, in any case, where there is a similar one.
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
  module.def(
      "parameter_table",
      [] {
        py::list rows;
        for (const ParameterInfo& info : parameter_table()) rows.append(row_of(info));
        return rows;
      },
      "Every parameter, in the order in which they are shown. The build writes this as "
      "base/parameters.json (see base/parameters.py).");

  module.def(
      "parameter_name",
      [](const std::string& name) {
        if (const ParameterInfo* info = find_parameter(name)) return std::string(info->name);
        refuse_unknown(name);
      },
      py::arg("name"), "A parameter's name by that or by an alias; raises InvalidInput.");

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
