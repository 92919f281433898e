// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/design_file.hpp"

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/design/design_arrays.hpp"

namespace curveups {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "curveups-design";
constexpr int format_version = 1;

[[noreturn]] void refuse(const std::string& field, const std::string& why) {
  throw InvalidInput("design file: field " + field + " " + why,
                     "give a file that 'curveups design' wrote");
}

Json to_json(const ParameterValue& value) {
  if (const double* x = std::get_if<double>(&value)) {
    // Whole numbers stay whole.
    if (*x == std::floor(*x) && std::abs(*x) < 1e15) return static_cast<long long>(*x);
    return *x;
  }
  if (const bool* b = std::get_if<bool>(&value)) return *b;
  return std::get<std::string>(value);
}

// Nested arrays of a matrix whose rows are blocks of `shape`, e.g. M x 6 as M x 2 x 3.
template <class Matrix>
Json to_json(const Matrix& m, int rows_per_entry) {
  Json out = Json::array();
  for (int i = 0; i < m.rows(); ++i) {
    Json entry = Json::array();
    const int width = static_cast<int>(m.cols()) / rows_per_entry;
    for (int r = 0; r < rows_per_entry; ++r) {
      Json row = Json::array();
      for (int c = 0; c < width; ++c) row.push_back(m(i, r * width + c));
      if (rows_per_entry == 1) {
        entry = std::move(row);
      } else {
        entry.push_back(std::move(row));
      }
    }
    out.push_back(std::move(entry));
  }
  return out;
}

const Json& field(const Json& json, const char* name) {
  const auto it = json.find(name);
  if (it == json.end()) refuse("\"" + std::string(name) + "\"", "is missing");
  return *it;
}

template <class Matrix>
Matrix read_matrix(const Json& json, const std::string& name, int columns, int rows_per_entry) {
  if (!json.is_array()) refuse("\"" + name + "\"", "is no array");
  Matrix m(static_cast<Eigen::Index>(json.size()), columns);
  const int width = columns / rows_per_entry;
  using Scalar = typename Matrix::Scalar;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string where = "\"" + name + "\"[" + std::to_string(i) + "]";
    const Json& entry = json[i];
    if (!entry.is_array() ||
        entry.size() != static_cast<std::size_t>(rows_per_entry == 1 ? width : rows_per_entry)) {
      refuse(where, "has the wrong shape");
    }
    for (int r = 0; r < rows_per_entry; ++r) {
      const Json& row = rows_per_entry == 1 ? entry : entry[static_cast<std::size_t>(r)];
      if (!row.is_array() || row.size() != static_cast<std::size_t>(width)) {
        refuse(where, "has the wrong shape");
      }
      for (int c = 0; c < width; ++c) {
        const Json& value = row[static_cast<std::size_t>(c)];
        const bool fits =
            std::is_integral_v<Scalar> ? value.is_number_integer() : value.is_number();
        if (!fits) refuse(where, "holds what is no number of the right kind");
        if constexpr (std::is_integral_v<Scalar>) {
          const long long x = value.get<long long>();
          if (x < 0 || x > 1000000000) refuse(where, "holds an index out of range");
          m(static_cast<Eigen::Index>(i), r * width + c) = static_cast<Scalar>(x);
        } else {
          const double x = value.get<double>();
          if (!std::isfinite(x)) refuse(where, "holds a number that is not finite");
          m(static_cast<Eigen::Index>(i), r * width + c) = x;
        }
      }
    }
  }
  return m;
}

TriangleMesh read_mesh(const Json& json, const std::string& prefix) {
  TriangleMesh mesh;
  mesh.V = read_matrix<Points3>(field(json, "V"), prefix + "V", 3, 1);
  mesh.F = read_matrix<Triangles>(field(json, "F"), prefix + "F", 3, 1);
  return mesh;
}

}  // namespace

std::string write_design(const Design& design) {
  Json parameters = Json::object();
  for (const ParameterInfo& info : parameter_table()) {
    parameters[std::string(info.name)] = to_json(get_parameter(design.parameters, info.name));
  }
  std::vector<std::pair<std::string, Json>> fields = {
      {"format", format_name},
      {"version", format_version},
      {"name", design.name},
      {"parameters", std::move(parameters)},
      {"V", to_json(design.mesh.V, 1)},
      {"F", to_json(design.mesh.F, 1)},
      {"T", to_json(design.T, 3)},
      {"q", to_json(design.q, 2)},
      {"cuts", to_json(design.cuts, 1)},
  };
  if (design.target) {
    fields.push_back(
        {"target", Json{{"V", to_json(design.target->V, 1)}, {"F", to_json(design.target->F, 1)}}});
  }
  std::string text = "{\n";
  for (std::size_t k = 0; k < fields.size(); ++k) {
    text += "  " + Json(fields[k].first).dump() + ": " + fields[k].second.dump();
    text += k + 1 < fields.size() ? ",\n" : "\n";
  }
  return text + "}\n";
}

Design read_design(const std::string& text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    throw InvalidInput("design file: not JSON (" + std::string(error.what()) + ")",
                       "give a file that 'curveups design' wrote");
  }
  if (!json.is_object()) {
    throw InvalidInput("design file: not a JSON object",
                       "give a file that 'curveups design' wrote");
  }
  const Json& format = field(json, "format");
  if (!format.is_string() || format.get<std::string>() != format_name) {
    refuse("\"format\"", "is not \"" + std::string(format_name) + "\"");
  }
  const Json& version = field(json, "version");
  if (!version.is_number_integer() || version.get<long long>() != format_version) {
    refuse("\"version\"", "is not " + std::to_string(format_version));
  }
  Design design;
  const Json& name = field(json, "name");
  if (!name.is_string()) refuse("\"name\"", "is no text");
  design.name = name.get<std::string>();
  const Json& parameters = field(json, "parameters");
  if (!parameters.is_object()) refuse("\"parameters\"", "is no object");
  for (const auto& [key, value] : parameters.items()) {
    if (value.is_boolean()) {
      set_parameter(design.parameters, key, value.get<bool>());
    } else if (value.is_number()) {
      set_parameter(design.parameters, key, value.get<double>());
    } else if (value.is_string()) {
      set_parameter(design.parameters, key, value.get<std::string>());
    } else {
      refuse("\"parameters\".\"" + key + "\"", "is no number, text or switch");
    }
  }
  check_parameters(design.parameters);
  design.mesh = read_mesh(json, "");
  design.T = read_matrix<FlatCorners>(field(json, "T"), "T", 6, 3);
  design.q = read_matrix<Array6>(field(json, "q"), "q", 6, 2);
  design.cuts = read_matrix<Edges>(field(json, "cuts"), "cuts", 2, 1);
  if (json.contains("target")) {
    const Json& target = json["target"];
    if (!target.is_object()) refuse("\"target\"", "is no object");
    design.target = read_mesh(target, "target.");
  }
  if (const auto fault = find_array_fault(design)) {
    refuse(fault->field, fault->why);
  }
  return design;
}

}  // namespace curveups
