// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/boundary_spacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace curveups {
namespace {

// A point to be inserted into the boundary edge that starts in a vertex, or that vertex itself.
struct Mark {
  int vertex;
  double share;  // of the edge, 0 at its start
};

// Vertices within this share of an edge's end stand for points near them.
constexpr double snap_share = 1e-6;

std::vector<Mark> marks_of_loop(const Points3& V, const std::vector<int>& loop, double length,
                                double corner_angle) {
  const int count = static_cast<int>(loop.size());
  std::vector<double> arc(1, 0.0);
  std::vector<int> corners;
  for (int i = 0; i < count; ++i) {
    const Vec3 in = V.row(loop[i]) - V.row(loop[(i + count - 1) % count]);
    const Vec3 out = V.row(loop[(i + 1) % count]) - V.row(loop[i]);
    arc.push_back(arc.back() + out.norm());
    if (std::atan2(in.cross(out).norm(), in.dot(out)) > corner_angle) corners.push_back(i);
  }
  const bool smooth = corners.empty();
  if (smooth) corners.push_back(0);
  const int stretches = static_cast<int>(corners.size());
  const int least = stretches >= 3 ? 1 : stretches == 2 ? 2 : 3;
  std::vector<Mark> marks;
  for (int s = 0; s < stretches; ++s) {
    const double from = arc[corners[s]];
    const double to = s + 1 < stretches ? arc[corners[s + 1]] : arc[corners[0]] + arc.back();
    const int parts = std::max(least, static_cast<int>(std::lround((to - from) / length)));
    marks.push_back({loop[corners[s]], 0});
    for (int k = 1; k < parts; ++k) {
      double at = from + (to - from) * k / parts;
      if (at >= arc.back()) at -= arc.back();
      int i = static_cast<int>(std::upper_bound(arc.begin(), arc.end(), at) - arc.begin()) - 1;
      i = std::clamp(i, 0, count - 1);
      const double edge = arc[i + 1] - arc[i];
      const double share = edge > 0 ? (at - arc[i]) / edge : 0;
      if (share > 1 - snap_share) {
        marks.push_back({loop[(i + 1) % count], 0});
      } else {
        marks.push_back({loop[i], share < snap_share ? 0 : share});
      }
    }
  }
  return marks;
}

}  // namespace

IsotropicMesh space_boundary(const TriangleMesh& mesh, double length, double corner_angle) {
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
  std::vector<Vec3> points(mesh.V.rows());
  for (int v = 0; v < mesh.V.rows(); ++v) points[v] = mesh.V.row(v);
  std::vector<char> fixed(points.size(), 0);
  std::unordered_map<int, int> next;  // along the boundary
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) next[edge.v[0]] = edge.v[1];
  }
  std::unordered_map<int, std::vector<std::pair<double, int>>> inserted;  // by the edge's start
  for (const std::vector<int>& loop : boundary_loops(topology)) {
    for (const Mark& mark : marks_of_loop(mesh.V, loop, length, corner_angle)) {
      if (mark.share == 0) {
        fixed[mark.vertex] = 1;
        continue;
      }
      const Vec3 a = mesh.V.row(mark.vertex), b = mesh.V.row(next[mark.vertex]);
      inserted[mark.vertex].emplace_back(mark.share, static_cast<int>(points.size()));
      points.push_back((1 - mark.share) * a + mark.share * b);
      fixed.push_back(1);
    }
  }
  for (auto& [start, list] : inserted) std::sort(list.begin(), list.end());

  std::vector<std::array<int, 3>> faces;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    int base_side = -1;  // a side with inserted vertices
    for (int t = 0; t < 3; ++t) {
      if (topology.neighbour(f, t) < 0 && inserted.count(mesh.F(f, t)) != 0) base_side = t;
    }
    if (base_side < 0) {
      faces.push_back({mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)});
      continue;
    }
    // Divide side by side: the fan of that side from the opposite corner, then, in the fan's
    // outer triangles, the fans of the other two sides.
    const auto side = [&](int t) {
      std::vector<int> chain(1, mesh.F(f, t));
      const auto it = inserted.find(mesh.F(f, t));
      if (topology.neighbour(f, t) < 0 && it != inserted.end()) {
        for (const auto& entry : it->second) chain.push_back(entry.second);
      }
      chain.push_back(mesh.F(f, next3(t)));
      return chain;
    };
    const std::vector<int> base = side(base_side), right = side(next3(base_side)),
                           left = side(prev3(base_side));
    const int top = mesh.F(f, prev3(base_side));
    for (std::size_t k = 1; k + 2 < base.size(); ++k) faces.push_back({base[k], base[k + 1], top});
    for (std::size_t k = 0; k + 1 < right.size(); ++k) {
      faces.push_back({right[k], right[k + 1], base[base.size() - 2]});
    }
    for (std::size_t k = 0; k + 1 < left.size(); ++k) {
      faces.push_back({left[k], left[k + 1], base[1]});
    }
  }
  IsotropicMesh out;
  out.fixed = std::move(fixed);
  out.mesh.V.resize(points.size(), 3);
  for (std::size_t v = 0; v < points.size(); ++v) out.mesh.V.row(v) = points[v];
  out.mesh.F.resize(faces.size(), 3);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    out.mesh.F.row(f) << faces[f][0], faces[f][1], faces[f][2];
  }
  return out;
}

}  // namespace curveups
