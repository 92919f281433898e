// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/even_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "curveups/core/parallel.hpp"

namespace curveups {
namespace {

template <class Wrong>
std::vector<int> faces_where(const Triangles& F, const Wrong& wrong) {
  std::vector<char> marked(F.rows(), 0);
  parallel_for(static_cast<int>(F.rows()), [&](int f) { marked[f] = wrong(f); });
  std::vector<int> out;
  for (int f = 0; f < F.rows(); ++f) {
    if (marked[f]) out.push_back(f);
  }
  return out;
}

// Least angle that a flip may make, rad.
constexpr double least_angle = 0.35;
// Angle below which a face is flipped away whatever the valences, rad: collapsing leaves such faces
// on three boundary vertices on a line.
constexpr double cap_angle = 0.05;

double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto angle = [](const Vec3& u, const Vec3& v) {
    return std::atan2(u.cross(v).norm(), u.dot(v));
  };
  return std::min({angle(b - a, c - a), angle(c - b, a - b), angle(a - c, b - c)});
}

// Takes one damped step of all springs; vertices that are not held return to the surface.
void relax_springs(const Triangles& F, SurfacePoints& points, const MeshTopology& topology,
                   double length, const std::vector<char>& held, const ClosestPoints& surface) {
  const Points3& V = points.V;
  Points3 move = Points3::Zero(V.rows(), 3);
  Eigen::VectorXd degree = Eigen::VectorXd::Zero(V.rows());
  for (const MeshEdge& edge : topology.edges) {
    const Vec3 d = V.row(edge.v[1]) - V.row(edge.v[0]);
    const double size = std::max(d.norm(), 1e-12 * length);
    const Vec3 pull = (1 - length / size) * d;
    move.row(edge.v[0]) += pull;
    move.row(edge.v[1]) -= pull;
    degree[edge.v[0]] += 1;
    degree[edge.v[1]] += 1;
  }
  SurfacePoints moved = points;
  parallel_for(static_cast<int>(V.rows()), [&](int v) {
    if (held[v] || degree[v] == 0) return;
    const Vec3 p = V.row(v) + 0.8 / degree[v] * move.row(v);
    const ClosestPoint closest = surface(p);
    moved.V.row(v) = closest.point;
    moved.normal.row(v) = surface.normal(closest.face);
  });
  undo_unsound_moves(F, points, moved);
  points = std::move(moved);
}

}  // namespace

double soundness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (!(longest > 0)) return 0;
  const Vec3 area = (b - a).cross(c - a);
  const double size = normal.norm();
  return (size > 0 ? area.dot(normal) / size : area.norm()) / longest;
}

double soundness(const SurfacePoints& points, const Triangles& F, int face) {
  const int a = F(face, 0), b = F(face, 1), c = F(face, 2);
  const Vec3 normal = points.normal.row(a) + points.normal.row(b) + points.normal.row(c);
  return soundness(points.V.row(a), points.V.row(b), points.V.row(c), normal);
}

std::vector<int> unsound_faces(const SurfacePoints& points, const Triangles& F) {
  return faces_where(F, [&](int f) { return soundness(points, F, f) < least_soundness; });
}

void undo_unsound_moves(const Triangles& F, const SurfacePoints& before, SurfacePoints& after) {
  // Ends: a face without a moving vertex is as before.
  for (;;) {
    const std::vector<int> spoiled = faces_where(F, [&](int f) {
      const double now = soundness(after, F, f);
      return now < least_soundness && now < soundness(before, F, f);
    });
    if (spoiled.empty()) return;
    for (int f : spoiled) {
      for (int v : F.row(f)) {
        after.V.row(v) = before.V.row(v);
        after.normal.row(v) = before.normal.row(v);  // a point on an edge may have several
      }
    }
  }
}

int flip_towards_regular(IsotropicMesh& mesh, const std::vector<char>& kept) {
  Triangles& F = mesh.mesh.F;
  const Points3& V = mesh.mesh.V;
  const MeshTopology topology = build_topology(F);
  std::vector<int> excess(V.rows(), -6);
  std::unordered_set<std::uint64_t> joined;
  for (const MeshEdge& edge : topology.edges) {
    for (int v : edge.v) {
      ++excess[v];
      if (edge.boundary()) ++excess[v];  // twice per boundary vertex: valence 4 is regular there
    }
    joined.insert(edge_key(edge.v[0], edge.v[1]));
  }
  std::unordered_set<std::uint64_t> features;
  for (const auto& [a, b] : mesh.features) features.insert(edge_key(a, b));
  std::vector<char> touched = kept;
  touched.resize(F.rows(), 0);
  int flips = 0;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary() || touched[edge.face[0]] || touched[edge.face[1]]) continue;
    const int a = edge.v[0], b = edge.v[1];
    if (features.count(edge_key(a, b)) != 0) continue;
    const int c = F(edge.face[0], prev3(edge.side[0])), d = F(edge.face[1], prev3(edge.side[1]));
    const auto square = [](int x) { return x * x; };
    const int before =
        square(excess[a]) + square(excess[b]) + square(excess[c]) + square(excess[d]);
    const int after = square(excess[a] - 1) + square(excess[b] - 1) + square(excess[c] + 1) +
                      square(excess[d] + 1);
    const Vec3 A = V.row(a), B = V.row(b), C = V.row(c), D = V.row(d);
    const double worst = std::min(smallest_angle(A, B, C), smallest_angle(B, A, D));
    const double flipped = std::min(smallest_angle(C, D, B), smallest_angle(D, C, A));
    const bool regular = after < before && flipped > std::min(least_angle, worst);
    const bool cap = worst < cap_angle && flipped > 2 * worst;
    if (!regular && !cap && !(after == before && flipped > worst + 0.05)) continue;
    if (joined.count(edge_key(c, d)) != 0) continue;
    // Weighted by area where one is flat and has no normal of its own.
    const Vec3 first = (B - A).cross(C - A), second = (A - B).cross(D - B);
    const Vec3 normal = cap ? Vec3(first + second) : first.normalized() + second.normalized();
    if ((D - C).cross(B - C).dot(normal) <= 0 || (C - D).cross(A - D).dot(normal) <= 0) continue;
    F.row(edge.face[0]) << c, d, b;
    F.row(edge.face[1]) << d, c, a;
    touched[edge.face[0]] = touched[edge.face[1]] = 1;
    joined.erase(edge_key(a, b));
    joined.insert(edge_key(c, d));
    --excess[a];
    --excess[b];
    ++excess[c];
    ++excess[d];
    ++flips;
  }
  return flips;
}

SurfacePoints even_edges(IsotropicMesh& mesh, double length, int passes,
                         const ClosestPoints& surface, bool flips) {
  const int vertices = static_cast<int>(mesh.mesh.V.rows());
  MeshTopology topology = build_topology(mesh.mesh.F);
  std::vector<char> held = boundary_vertices(topology, vertices);
  SurfacePoints points{mesh.mesh.V, Points3(vertices, 3)};
  std::vector<char> on_feature(vertices, 0);  // the surface has two normals there
  for (const auto& [a, b] : mesh.features) on_feature[a] = on_feature[b] = 1;
  parallel_for(vertices, [&](int v) {
    held[v] |= mesh.fixed[v] || on_feature[v];
    if (on_feature[v]) {
      points.normal.row(v).setZero();
    } else {
      points.normal.row(v) = surface.normal(surface(points.V.row(v)).face);
    }
  });
  for (int pass = 0; pass < passes; ++pass) {
    relax_springs(mesh.mesh.F, points, topology, length, held, surface);
    mesh.mesh.V = points.V;
    if (flips && pass % 4 == 3 && flip_towards_regular(mesh) > 0) {
      topology = build_topology(mesh.mesh.F);
    }
  }
  return points;
}

}  // namespace curveups
