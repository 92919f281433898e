// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/bevel_edges.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/closest_points.hpp"
#include "curveups/geometry/feature_lines.hpp"
#include "curveups/numerics/sparse_cholesky.hpp"

namespace curveups {
namespace {

// A new vertex this near to an end of its edge (share of the edge) is that end.
constexpr double snap_share = 0.02;

// How far the edge itself moves towards where a flat strip would be. An edge of 90 degrees becomes
// three of 30 with 1 - tan(15) / tan(45).
constexpr double edge_share = 0.732;

MeshTopology topology_of(const TriangleMesh& mesh) {
  return build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
}

// By how much the surface turns across an edge: angle between the mean normals of the faces on
// either side, as far as `reach` from its middle. Facets of a noisy scan cancel out.
class WideTurn {
 public:
  WideTurn(const TriangleMesh& mesh, const MeshTopology& topology, double reach)
      : mesh_(mesh), topology_(topology), reach_(reach), seen_(mesh.F.rows(), -1) {}

  double operator()(const MeshEdge& edge) {
    const Vec3 a = mesh_.V.row(edge.v[0]), b = mesh_.V.row(edge.v[1]), middle = 0.5 * (a + b);
    const Vec3 normal =
        face_area_vector(mesh_, edge.face[0]) + face_area_vector(mesh_, edge.face[1]);
    const Vec3 across = normal.cross(b - a);  // towards the first face
    Vec3 sum[2] = {Vec3::Zero(), Vec3::Zero()};
    std::vector<int> faces(edge.face, edge.face + 2);
    ++query_;
    for (int f : faces) seen_[f] = query_;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Vec3 from = centre(faces[i]) - middle;
      const bool second = i < 2 ? i == 1 : from.dot(across) < 0;
      sum[second] += face_area_vector(mesh_, faces[i]);
      for (int t = 0; t < 3; ++t) {
        const int next = topology_.neighbour(faces[i], t);
        if (next < 0 || seen_[next] == query_) continue;
        seen_[next] = query_;
        if ((centre(next) - middle).norm() <= reach_) faces.push_back(next);
      }
    }
    return std::atan2(sum[0].cross(sum[1]).norm(), sum[0].dot(sum[1]));
  }

 private:
  Vec3 centre(int face) const {
    Vec3 sum = Vec3::Zero();
    for (int t = 0; t < 3; ++t) sum += Vec3(mesh_.V.row(mesh_.F(face, t)));
    return sum / 3;
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  double reach_;
  std::vector<int> seen_;
  int query_ = 0;
};

// The edges that turn by more than `angle`, among facets and on the whole.
Edges wide_creases(const TriangleMesh& mesh, const MeshTopology& topology, double angle,
                   const BevelOptions& options) {
  const Edges creases =
      crease_edges(mesh, topology, options.keep_angle, options.L * options.shortest);
  std::set<std::array<int, 2>> sharp;
  for (int e = 0; e < creases.rows(); ++e) sharp.insert({creases(e, 0), creases(e, 1)});
  WideTurn turn(mesh, topology, options.L * options.reach);
  VertexPairs out;
  for (const MeshEdge& edge : topology.edges) {
    const auto ends = std::minmax(edge.v[0], edge.v[1]);
    if (!edge.boundary() && sharp.count({ends.first, ends.second}) && turn(edge) > angle) {
      out.push_back({ends.first, ends.second});
    }
  }
  std::sort(out.begin(), out.end());
  return long_lines(mesh, out, options.L * options.shortest);
}

// Distances from edges of a mesh.
Eigen::VectorXd distances_from(const Points3& points, const TriangleMesh& mesh,
                               const Edges& edges) {
  // The tree wants triangles: the third corner is a millionth of the edge off.
  TriangleMesh fins{Points3(3 * edges.rows(), 3), Triangles(edges.rows(), 3)};
  for (int e = 0; e < edges.rows(); ++e) {
    const Vec3 a = mesh.V.row(edges(e, 0)), b = mesh.V.row(edges(e, 1));
    fins.V.row(3 * e) = a;
    fins.V.row(3 * e + 1) = b;
    fins.V.row(3 * e + 2) = 0.5 * (a + b) + 1e-6 * (b - a).unitOrthogonal() * (b - a).norm();
    fins.F.row(e) << 3 * e, 3 * e + 1, 3 * e + 2;
  }
  return distances(points, ClosestPoints(fins));
}

// Splits edges at given vertices (-1: not), and their faces.
void split_edges(TriangleMesh& mesh, const MeshTopology& topology, const std::vector<int>& at) {
  std::vector<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    std::array<int, 3> c, m;
    int count = 0, first = 0, whole = 0;  // a side that is split, and one that is not
    for (int t = 0; t < 3; ++t) {
      c[t] = mesh.F(f, t);
      m[t] = at[topology.edge_of(f, t)];
      count += m[t] >= 0;
      (m[t] >= 0 ? first : whole) = t;
    }
    const int turn = count == 1 ? first : (whole + 1) % 3;  // becomes side 0
    std::rotate(c.begin(), c.begin() + turn, c.end());
    std::rotate(m.begin(), m.begin() + turn, m.end());
    if (count == 0) faces.push_back({mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)});
    if (count == 1) faces.insert(faces.end(), {{c[0], m[0], c[2]}, {m[0], c[1], c[2]}});
    if (count == 2) {
      faces.insert(faces.end(), {{m[0], c[1], m[1]}, {c[0], m[0], m[1]}, {c[0], m[1], c[2]}});
    }
    if (count == 3) {
      faces.insert(
          faces.end(),
          {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}});
    }
  }
  mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    mesh.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
  }
}

void append(Points3& V, const std::vector<Vec3>& points) {
  const Eigen::Index before = V.rows();
  V.conservativeResize(before + static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    V.row(before + static_cast<Eigen::Index>(k)) = points[k];
  }
}

// Halves edges until none within `width` of the creases is longer than that.
void refine_beside(TriangleMesh& mesh, const TriangleMesh& given, const Edges& creases,
                   double width) {
  for (;;) {
    checkpoint();
    const MeshTopology topology = topology_of(mesh);
    std::vector<int> longer;
    std::vector<Vec3> middle;
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const Vec3 a = mesh.V.row(topology.edges[e].v[0]), b = mesh.V.row(topology.edges[e].v[1]);
      if ((b - a).norm() <= width) continue;
      longer.push_back(static_cast<int>(e));
      middle.push_back(0.5 * (a + b));
    }
    Points3 points(0, 3);
    append(points, middle);
    if (points.rows() == 0) return;
    const Eigen::VectorXd away = distances_from(points, given, creases);
    std::vector<int> at(topology.edges.size(), -1);
    std::vector<Vec3> added;
    for (std::size_t k = 0; k < longer.size(); ++k) {
      const auto& ends = topology.edges[longer[k]].v;
      const double half = 0.5 * (mesh.V.row(ends[1]) - mesh.V.row(ends[0])).norm();
      if (away[static_cast<Eigen::Index>(k)] > width + half) continue;
      at[longer[k]] = static_cast<int>(mesh.V.rows()) + static_cast<int>(added.size());
      added.push_back(middle[k]);
    }
    if (added.empty()) return;
    append(mesh.V, added);
    split_edges(mesh, topology, at);
  }
}

// Splits edges where the distance from creases passes `width`; returns how far vertices are beyond.
std::vector<double> split_at(TriangleMesh& mesh, const Eigen::VectorXd& away, double width) {
  std::vector<double> beyond(away.size());
  for (Eigen::Index v = 0; v < away.size(); ++v) beyond[v] = away[v] - width;
  const MeshTopology topology = topology_of(mesh);
  const auto share = [&](const MeshEdge& edge) {
    return beyond[edge.v[0]] / (beyond[edge.v[0]] - beyond[edge.v[1]]);
  };
  for (const MeshEdge& edge : topology.edges) {
    if (beyond[edge.v[0]] * beyond[edge.v[1]] >= 0) continue;
    if (share(edge) < snap_share) {
      beyond[edge.v[0]] = 0;
    } else if (share(edge) > 1 - snap_share) {
      beyond[edge.v[1]] = 0;
    }
  }
  std::vector<int> at(topology.edges.size(), -1);
  std::vector<Vec3> added;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (beyond[edge.v[0]] * beyond[edge.v[1]] >= 0) continue;
    at[e] = static_cast<int>(mesh.V.rows()) + static_cast<int>(added.size());
    const double s = share(edge);
    added.push_back((1 - s) * mesh.V.row(edge.v[0]) + s * mesh.V.row(edge.v[1]));
  }
  append(mesh.V, added);
  beyond.resize(mesh.V.rows(), 0.0);
  split_edges(mesh, topology, at);
  return beyond;
}

// Moves the vertices marked `free` to where each is the mean of its neighbours along `edges`; those
// that no chain of edges joins to one that stays, stay.
void span(Points3& V, const VertexPairs& edges, std::vector<char> free) {
  std::vector<std::vector<int>> next(V.rows());
  for (const auto& [a, b] : edges) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  std::vector<int> held, unknown(V.rows(), -1);
  for (int v = 0; v < V.rows(); ++v) {
    if (!free[v]) held.push_back(v);
  }
  int count = 0;
  for (std::size_t i = 0; i < held.size(); ++i) {
    for (int v : next[held[i]]) {
      if (!free[v] || unknown[v] >= 0) continue;
      unknown[v] = count++;
      held.push_back(v);
    }
  }
  if (count == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(count, 3);
  for (int v = 0; v < V.rows(); ++v) {
    if (unknown[v] < 0) continue;
    entries.emplace_back(unknown[v], unknown[v], static_cast<double>(next[v].size()));
    for (int u : next[v]) {
      if (unknown[u] < 0) {
        sides.row(unknown[v]) += V.row(u);
      } else if (unknown[u] < unknown[v]) {
        entries.emplace_back(unknown[v], unknown[u], -1.0);
      }
    }
  }
  SparseMatrix lower(count, count);
  lower.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky factor;
  if (!factor.factorize(lower)) return;  // joined to what stays: it is positive definite
  const Eigen::MatrixXd found = factor.solve(sides);
  for (int v = 0; v < V.rows(); ++v) {
    if (unknown[v] >= 0) V.row(v) = found.row(unknown[v]);
  }
}

void check(const TriangleMesh& mesh, const BevelOptions& options) {
  for (double value : {options.L, options.keep_angle, options.bevel_angle, options.half_width,
                       options.reach, options.shortest}) {
    if (!(value > 0) || !std::isfinite(value)) {
      throw InvalidInput("a length or an angle of a bevel is not positive",
                         "give positive numbers");
    }
  }
  if (mesh.F.rows() == 0) throw InvalidInput("the surface has no faces", "check the input file");
}

// Moves what is within `width` of the creases (of `given`). beyond: how far each vertex of `mesh`
// is from the strips, 0 on their rims. Returns the lines.
std::set<std::array<int, 2>> round_off(TriangleMesh& mesh, const std::vector<double>& beyond,
                                       double width) {
  const MeshTopology topology = topology_of(mesh);
  const auto inside = [&](int face) {
    double most = -width, least = 0;
    for (int t = 0; t < 3; ++t) {
      most = std::max(most, beyond[mesh.F(face, t)]);
      least = std::min(least, beyond[mesh.F(face, t)]);
    }
    return most <= 0 && least < 0;
  };
  const auto on_edge = [&](int v) { return beyond[v] < -(1 - 1e-4) * width; };
  std::set<std::array<int, 2>> lines;
  VertexPairs all, border;
  std::vector<char> free(mesh.V.rows()), at_border(mesh.V.rows(), 0);
  for (std::size_t v = 0; v < free.size(); ++v) free[v] = beyond[v] < 0;
  for (const MeshEdge& edge : topology.edges) {
    const auto ends = std::minmax(edge.v[0], edge.v[1]);
    all.push_back({ends.first, ends.second});
    if (edge.boundary()) {
      border.push_back(all.back());
      for (int v : edge.v) at_border[v] = 1;
    } else if (inside(edge.face[0]) != inside(edge.face[1]) ||
               (on_edge(ends.first) && on_edge(ends.second))) {
      lines.insert(all.back());
    }
  }
  const auto span_strips = [&] {
    std::vector<char> here = free;
    for (std::size_t v = 0; v < here.size(); ++v) here[v] = free[v] && at_border[v];
    span(mesh.V, border, here);
    for (std::size_t v = 0; v < here.size(); ++v) here[v] = free[v] && !at_border[v];
    span(mesh.V, all, here);
  };
  const Points3 before = mesh.V;
  span_strips();
  for (int v = 0; v < before.rows(); ++v) {
    if (!on_edge(v)) continue;
    mesh.V.row(v) = before.row(v) + edge_share * (mesh.V.row(v) - before.row(v));
    free[v] = 0;
  }
  span_strips();
  return lines;
}

}  // namespace

BevelledMesh bevel_edges(const TriangleMesh& mesh, const BevelOptions& options) {
  check(mesh, options);
  BevelledMesh out{mesh, Edges(0, 2), 0};
  const double width = options.L * options.half_width;
  const Edges creases = wide_creases(mesh, topology_of(mesh), options.bevel_angle, options);
  std::vector<double> beyond(mesh.V.rows(), 1.0);
  std::set<std::array<int, 2>> lines;
  if (creases.rows() > 0) {
    for (int e = 0; e < creases.rows(); ++e) {
      out.length += (mesh.V.row(creases(e, 0)) - mesh.V.row(creases(e, 1))).norm();
    }
    refine_beside(out.mesh, mesh, creases, width);
    beyond = split_at(out.mesh, distances_from(out.mesh.V, mesh, creases), width);
    lines = round_off(out.mesh, beyond, width);
  }
  const Edges kept = wide_creases(out.mesh, topology_of(out.mesh), options.keep_angle, options);
  for (int e = 0; e < kept.rows(); ++e) {
    if (beyond[kept(e, 0)] >= 0 && beyond[kept(e, 1)] >= 0) lines.insert({kept(e, 0), kept(e, 1)});
  }
  out.lines = to_edges({lines.begin(), lines.end()});
  return out;
}

}  // namespace curveups
