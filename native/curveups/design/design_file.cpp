// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/design_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"

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

// Nested arrays of a matrix whose rows are blocks, e.g. M x 6 as M x 2 x 3.
template <class Matrix>
Json to_json(const Matrix& m, int rows_per_entry) {
  const int width = static_cast<int>(m.cols()) / rows_per_entry;
  Json out = Json::array();
  for (int i = 0; i < m.rows(); ++i) {
    Json entry = Json::array();
    for (int r = 0; r < rows_per_entry; ++r) {
      Json row = Json::array();
      for (int c = 0; c < width; ++c) row.push_back(m(i, r * width + c));
      entry.push_back(std::move(row));
    }
    out.push_back(rows_per_entry == 1 ? std::move(entry[0]) : std::move(entry));
  }
  return out;
}

ParameterValue read_value(const Json& json, const std::string& name) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  refuse("\"parameters\".\"" + name + "\"", "is no number, text or switch");
}

const Json& field(const Json& json, const char* name) {
  const auto it = json.find(name);
  if (it == json.end()) refuse("\"" + std::string(name) + "\"", "is missing");
  return *it;
}

using Shape = std::vector<std::size_t>;

// Numbers of one row, nested as `shape` from `depth` on; false for another shape or kind.
template <class Row>
bool read_row(const Json& json, const Shape& shape, std::size_t depth, Row& row, int& next) {
  if (depth < shape.size()) {
    return json.is_array() && json.size() == shape[depth] &&
           std::all_of(json.begin(), json.end(), [&](const Json& part) {
             return read_row(part, shape, depth + 1, row, next);
           });
  }
  using Scalar = typename Row::Scalar;
  if (!(std::is_integral_v<Scalar> ? json.is_number_integer() : json.is_number())) return false;
  const double value = json.get<double>();
  if (std::is_integral_v<Scalar> && std::abs(value) > 1e9) return false;
  row(next++) = static_cast<Scalar>(value);
  return true;
}

template <class Matrix>
Matrix read_matrix(const Json& json, const std::string& name, const Shape& shape) {
  if (!json.is_array()) refuse("\"" + name + "\"", "is no array");
  Matrix m(static_cast<Eigen::Index>(json.size()), Eigen::Index{Matrix::ColsAtCompileTime});
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    auto row = m.row(i);
    int next = 0;
    if (!read_row(json[static_cast<std::size_t>(i)], shape, 0, row, next)) {
      refuse("\"" + name + "\"[" + std::to_string(i) + "]", "has the wrong shape");
    }
  }
  return m;
}

TriangleMesh read_mesh(const Json& json, const std::string& prefix) {
  TriangleMesh mesh;
  mesh.V = read_matrix<Points3>(field(json, "V"), prefix + "V", {3});
  mesh.F = read_matrix<Triangles>(field(json, "F"), prefix + "F", {3});
  return mesh;
}

[[noreturn]] void refuse_arrays(const std::string& field, const std::string& why) {
  throw InvalidInput("design: " + field + " " + why,
                     "give arrays that belong together, lengths in mm");
}

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

std::string entry(const std::string& name, Eigen::Index i) {
  return quoted(name) + "[" + std::to_string(i) + "]";
}

template <class Matrix>
void require_finite(const Matrix& m, const std::string& name) {
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    if (!m.row(i).allFinite()) refuse_arrays(entry(name, i), "is not finite");
    if (m.row(i).cwiseAbs().maxCoeff() > tolerance::largest_coordinate) {
      refuse_arrays(entry(name, i), "lies too far out");
    }
  }
}

template <class Matrix>
void require_vertices(const Matrix& indices, Eigen::Index count, const std::string& name) {
  for (Eigen::Index i = 0; i < indices.rows(); ++i) {
    const int low = indices.row(i).minCoeff(), high = indices.row(i).maxCoeff();
    if (low >= 0 && high < count) continue;
    refuse_arrays(entry(name, i), "names vertex " + std::to_string(low < 0 ? low : high) +
                                      ", there are " + std::to_string(count));
  }
}

void check_mesh(const TriangleMesh& mesh, const std::string& prefix) {
  if (mesh.F.rows() == 0) refuse_arrays(quoted(prefix + "F"), "is empty");
  require_finite(mesh.V, prefix + "V");
  require_vertices(mesh.F, mesh.V.rows(), prefix + "F");
}

void check_rows(const Array6& m, Eigen::Index tiles, const std::string& name) {
  if (m.rows() != tiles) {
    refuse_arrays(quoted(name), "has " + std::to_string(m.rows()) + " entries, \"F\" has " +
                                    std::to_string(tiles));
  }
  require_finite(m, name);
}

Vec3 actuated_lengths(const TriangleMesh& mesh, Eigen::Index tile) {
  Vec3 out;
  for (int t = 0; t < 3; ++t) {
    out[t] = (mesh.V.row(mesh.F(tile, next3(t))) - mesh.V.row(mesh.F(tile, t))).norm();
  }
  return out;
}

void check_unit(const Design& design) {
  double sum = 0;
  for (Eigen::Index i = 0; i < design.mesh.F.rows(); ++i) {
    sum += actuated_lengths(design.mesh, i).mean();
  }
  const double mean = sum / static_cast<double>(design.mesh.F.rows()), L = design.parameters.L;
  if (mean > L / 4 && mean < L * 4) return;
  char text[120];
  std::snprintf(text, sizeof text, "has edges of %.4g mm in the mean, parameter L says %.4g mm",
                mean, L);
  refuse_arrays(quoted("V"), text);
}

void check_congruence(const Design& design) {
  for (Eigen::Index i = 0; i < design.T.rows(); ++i) {
    const Vec2 corner[3] = {design.T.row(i).segment<2>(0), design.T.row(i).segment<2>(2),
                            design.T.row(i).segment<2>(4)};
    const Vec3 actuated = actuated_lengths(design.mesh, i);
    for (int t = 0; t < 3; ++t) {
      if (std::abs((corner[next3(t)] - corner[t]).norm() - actuated[t]) > 1e-3) {
        refuse_arrays(entry("T", i), "is not congruent to its tile in \"V\" and \"F\"");
      }
    }
    if (wedge(corner[1] - corner[0], corner[2] - corner[0]) <= 0) {
      refuse_arrays(entry("T", i), "is not counter-clockwise");
    }
  }
}

}  // namespace

void require_fitting_arrays(const Design& design) {
  check_mesh(design.mesh, "");
  check_rows(design.T, design.mesh.F.rows(), "T");
  check_rows(design.q, design.mesh.F.rows(), "q");
  require_vertices(design.cuts, design.mesh.V.rows(), "cuts");
  if (design.target) check_mesh(*design.target, "target.");
  check_unit(design);
  check_congruence(design);
}

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
    set_parameter(design.parameters, key, read_value(value, key));
  }
  check_parameters(design.parameters);
  design.mesh = read_mesh(json, "");
  design.T = read_matrix<FlatCorners>(field(json, "T"), "T", {3, 2});
  design.q = read_matrix<Array6>(field(json, "q"), "q", {2, 3});
  design.cuts = read_matrix<Edges>(field(json, "cuts"), "cuts", {2});
  if (json.contains("target")) {
    const Json& target = json["target"];
    if (!target.is_object()) refuse("\"target\"", "is no object");
    design.target = read_mesh(target, "target.");
  }
  require_fitting_arrays(design);
  return design;
}

}  // namespace curveups
