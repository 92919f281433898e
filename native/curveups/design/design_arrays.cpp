// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/design_arrays.hpp"

#include <cmath>
#include <cstdio>

#include "curveups/core/errors.hpp"
#include "curveups/core/tolerances.hpp"

namespace curveups {
namespace {

using Fault = std::optional<ArrayFault>;

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

std::string entry(const std::string& name, Eigen::Index i) {
  return quoted(name) + "[" + std::to_string(i) + "]";
}

template <class Matrix>
Fault not_finite(const Matrix& m, const std::string& name) {
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    if (!m.row(i).allFinite()) return ArrayFault{entry(name, i), "is not finite"};
    if (m.row(i).cwiseAbs().maxCoeff() > tolerance::largest_coordinate) {
      return ArrayFault{entry(name, i), "lies too far out"};
    }
  }
  return {};
}

template <class Matrix>
Fault no_such_vertex(const Matrix& indices, Eigen::Index count, const std::string& name) {
  for (Eigen::Index i = 0; i < indices.rows(); ++i) {
    const int low = indices.row(i).minCoeff(), high = indices.row(i).maxCoeff();
    if (low >= 0 && high < count) continue;
    return ArrayFault{entry(name, i), "names vertex " + std::to_string(low < 0 ? low : high) +
                                          ", there are " + std::to_string(count)};
  }
  return {};
}

Fault mesh_fault(const TriangleMesh& mesh, const std::string& prefix) {
  if (mesh.F.rows() == 0) return ArrayFault{quoted(prefix + "F"), "is empty"};
  if (Fault fault = not_finite(mesh.V, prefix + "V")) return fault;
  return no_such_vertex(mesh.F, mesh.V.rows(), prefix + "F");
}

Vec3 actuated_lengths(const TriangleMesh& mesh, Eigen::Index tile) {
  Vec3 out;
  for (int t = 0; t < 3; ++t) {
    out[t] = (mesh.V.row(mesh.F(tile, next3(t))) - mesh.V.row(mesh.F(tile, t))).norm();
  }
  return out;
}

Fault other_unit(const Design& design) {
  double sum = 0;
  for (Eigen::Index i = 0; i < design.mesh.F.rows(); ++i) {
    sum += actuated_lengths(design.mesh, i).mean();
  }
  const double mean = sum / static_cast<double>(design.mesh.F.rows()), L = design.parameters.L;
  if (mean > L / 4 && mean < L * 4) return {};
  char text[120];
  std::snprintf(text, sizeof text, "has edges of %.4g mm in the mean, parameter L says %.4g mm",
                mean, L);
  return ArrayFault{quoted("V"), text};
}

Fault not_congruent(const Design& design) {
  for (Eigen::Index i = 0; i < design.T.rows(); ++i) {
    const Vec2 corner[3] = {design.T.row(i).segment<2>(0), design.T.row(i).segment<2>(2),
                            design.T.row(i).segment<2>(4)};
    const Vec3 actuated = actuated_lengths(design.mesh, i);
    for (int t = 0; t < 3; ++t) {
      if (std::abs((corner[next3(t)] - corner[t]).norm() - actuated[t]) > 1e-3) {
        return ArrayFault{entry("T", i), "is not congruent to its tile in \"V\" and \"F\""};
      }
    }
    if (wedge(corner[1] - corner[0], corner[2] - corner[0]) <= 0) {
      return ArrayFault{entry("T", i), "is not counter-clockwise"};
    }
  }
  return {};
}

}  // namespace

std::optional<ArrayFault> find_array_fault(const Design& design) {
  if (Fault fault = mesh_fault(design.mesh, "")) return fault;
  const Eigen::Index tiles = design.mesh.F.rows();
  for (const auto& [name, m] : {std::pair<const char*, const Array6*>{"T", &design.T},
                                std::pair<const char*, const Array6*>{"q", &design.q}}) {
    if (m->rows() != tiles) {
      return ArrayFault{quoted(name), "has " + std::to_string(m->rows()) + " entries, \"F\" has " +
                                          std::to_string(tiles)};
    }
    if (Fault fault = not_finite(*m, name)) return fault;
  }
  if (Fault fault = no_such_vertex(design.cuts, design.mesh.V.rows(), "cuts")) return fault;
  if (design.target) {
    if (Fault fault = mesh_fault(*design.target, "target.")) return fault;
  }
  if (Fault fault = other_unit(design)) return fault;
  return not_congruent(design);
}

void require_fitting_arrays(const Design& design) {
  if (const Fault fault = find_array_fault(design)) {
    throw InvalidInput("design: " + fault->field + " " + fault->why,
                       "give arrays that belong together, lengths in mm");
  }
}

}  // namespace curveups
