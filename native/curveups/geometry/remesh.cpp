// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/remesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/clean_mesh.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/even_edges.hpp"
#include "curveups/geometry/line_spacing.hpp"
#include "curveups/geometry/surface_deviation.hpp"

namespace curveups {
namespace {

constexpr double corner_angle = 40 * 3.14159265358979323846 / 180;
constexpr int most_rounds = 6;  // trials for the length that gives the wanted mean
constexpr double mean_tolerance = 0.01;
constexpr double most_faces = 200000;
// CGAL's collapsing of short edges does not end on spikes of some 500 L; a square with edges of 300
// L has more tiles than most_faces.
constexpr double longest_edge_of_L = 300;

struct EdgeStatistics {
  double mean, deviation;
};

EdgeStatistics edge_statistics(const TriangleMesh& mesh) {
  const std::vector<double> lengths = edge_lengths(mesh, build_topology(mesh.F));
  double sum = 0, squares = 0;
  for (double length : lengths) {
    sum += length;
    squares += length * length;
  }
  const auto count = static_cast<double>(lengths.size());
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

std::size_t boundary_loop_count(const TriangleMesh& mesh) {
  return boundary_loops(build_topology(mesh.F)).size();
}

Edges all_features(const TriangleMesh& surface, const std::vector<std::array<int, 2>>& given,
                   const RemeshOptions& options) {
  Edges creases(0, 2);
  if (options.crease_angle < 3.14159) {
    const MeshTopology topology = build_topology(surface.F);
    creases = crease_edges(surface, topology, options.crease_angle, 2 * options.L);
  }
  Edges out(creases.rows() + static_cast<Eigen::Index>(given.size()), 2);
  out << creases, rows_of(given);
  return out;
}

// closest: tree over this component.
IsotropicMesh remesh_component(const TriangleMesh& surface, const ClosestPoints& closest,
                               const Edges& features, const RemeshOptions& options) {
  const std::size_t loops = boundary_loop_count(surface);
  IsotropicMesh mesh =
      space_lines(surface, features, options.L, corner_angle, options.corner_reach);
  checkpoint();

  double length = options.L;
  IsotropicMesh best;
  double best_error = -1;
  for (int round = 0; round < most_rounds; ++round) {
    checkpoint("remeshing", static_cast<double>(round) / most_rounds);
    mesh = isotropic_mesh(mesh, length, round == 0 ? 12 : 5);
    const auto faces = mesh.mesh.F.rows();  // a closed surface has at least four
    if (faces == 0 || (loops == 0 && faces < 4) || boundary_loop_count(mesh.mesh) != loops) {
      throw TopologyError("a part or a hole of the surface is too small for edges of " +
                              std::to_string(options.L) + " mm",
                          "choose a smaller L, or fill the hole");
    }
    const SurfacePoints points = even_edges(mesh, options.L, 60, closest);
    const EdgeStatistics edges = edge_statistics(mesh.mesh);
    const auto unsound = static_cast<double>(unsound_faces(points, mesh.mesh.F).size());
    const double error =  // slivers weigh more than any unevenness
        100 * unsound + std::abs(edges.mean / options.L - 1) + 2 * edges.deviation / edges.mean;
    if (best_error < 0 || error < best_error) {
      best = mesh;
      best_error = error;
    }
    if (std::abs(edges.mean / options.L - 1) < mean_tolerance &&
        edges.deviation < 0.11 * edges.mean) {
      break;
    }
    length *= std::clamp(options.L / edges.mean, 0.8, 1.25);
  }
  return best;
}

}  // namespace

RemeshResult remesh(const TriangleMesh& surface, const RemeshOptions& options) {
  if (!(options.L > 0) || !std::isfinite(options.L)) {
    throw InvalidInput("L must be a positive length", "give L in mm");
  }
  const ClosestPoints closest(surface);
  for (int f = 0; f < surface.F.rows(); ++f) {
    checkpoint_now_and_then(static_cast<std::size_t>(f));
    if (has_no_area(surface, f)) {
      throw InvalidInput("face " + std::to_string(f + 1) + " of the surface has no area",
                         "clean the mesh first");
    }
    for (int t = 0; t < 3; ++t) {
      const double length =
          (surface.V.row(surface.F(f, next3(t))) - surface.V.row(surface.F(f, t))).norm();
      if (length <= longest_edge_of_L * options.L) continue;
      throw InvalidInput("face " + std::to_string(f + 1) + " of the surface has an edge of " +
                             std::to_string(static_cast<long long>(length)) + " mm, L is " +
                             std::to_string(options.L) + " mm",
                         "look for a vertex far away from the others, or choose a larger L");
    }
  }
  const double expected = surface_area(surface) / (std::sqrt(3.0) / 4 * options.L * options.L);
  if (!(expected < most_faces)) {
    throw InvalidInput("the surface would need about " +
                           std::to_string(static_cast<long long>(std::min(expected, 1e15))) +
                           " tiles of L = " + std::to_string(options.L) + " mm",
                       "check the unit of the file (scale), or choose a larger L");
  }
  checkpoint("remeshing", 0);
  const MeshTopology topology = build_topology(surface.F);
  checkpoint();
  const std::vector<MeshPiece> parts = parts_of(surface, face_components(topology, {}));
  RemeshResult result;
  result.mesh.V.resize(0, 3);
  result.mesh.F.resize(0, 3);
  std::vector<std::array<int, 2>> features;
  for (const MeshPiece& piece : parts) {
    const TriangleMesh& part = piece.mesh;
    std::vector<int> number(surface.V.rows(), -1);
    for (std::size_t v = 0; v < piece.original.size(); ++v) {
      number[piece.original[v]] = static_cast<int>(v);
    }
    checkpoint();
    std::vector<std::array<int, 2>> given;
    for (int e = 0; e < options.features.rows(); ++e) {
      const int a = number[options.features(e, 0)], b = number[options.features(e, 1)];
      if (a >= 0 && b >= 0) given.push_back({a, b});
    }
    const Edges lines = all_features(part, given, options);
    checkpoint();
    std::optional<ClosestPoints> own;
    if (parts.size() > 1) own.emplace(part);
    checkpoint();
    const IsotropicMesh component = remesh_component(part, own ? *own : closest, lines, options);
    const TriangleMesh& tiles = component.mesh;
    const int first_vertex = static_cast<int>(result.mesh.V.rows());
    const int first_face = static_cast<int>(result.mesh.F.rows());
    result.mesh.V.conservativeResize(first_vertex + tiles.V.rows(), 3);
    result.mesh.V.bottomRows(tiles.V.rows()) = tiles.V;
    result.mesh.F.conservativeResize(first_face + tiles.F.rows(), 3);
    result.mesh.F.bottomRows(tiles.F.rows()) = tiles.F.array() + first_vertex;
    for (const auto& [a, b] : component.features) {
      features.push_back({a + first_vertex, b + first_vertex});
    }
  }
  result.features = rows_of(features);
  const EdgeStatistics edges = edge_statistics(result.mesh);
  result.mean_edge = edges.mean;
  result.edge_cv = edges.deviation / edges.mean;
  result.chord_error = largest_distance(surface, result.mesh);
  return result;
}

}  // namespace curveups
