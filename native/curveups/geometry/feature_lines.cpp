// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/feature_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace curveups {
namespace {

using Neighbours = std::map<int, std::vector<int>>;  // of a vertex along the lines, ascending

Neighbours neighbours_of(const Edges& edges) {
  Neighbours next;
  for (int e = 0; e < edges.rows(); ++e) {
    next[edges(e, 0)].push_back(edges(e, 1));
    next[edges(e, 1)].push_back(edges(e, 0));
  }
  for (auto& [vertex, list] : next) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return next;
}

}  // namespace

Edges crease_edges(const TriangleMesh& mesh, const MeshTopology& topology, double angle,
                   double least) {
  std::vector<std::array<int, 2>> sharp;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) continue;
    const Vec3 a = face_area_vector(mesh, edge.face[0]), b = face_area_vector(mesh, edge.face[1]);
    if (!(a.norm() > 0) || !(b.norm() > 0)) continue;
    if (std::atan2(a.cross(b).norm(), a.dot(b)) <= angle) continue;
    sharp.push_back({std::min(edge.v[0], edge.v[1]), std::max(edge.v[0], edge.v[1])});
  }
  std::sort(sharp.begin(), sharp.end());
  const Neighbours next = neighbours_of(rows_of(sharp));
  std::set<int> noise, seen;  // vertices of sets that are too short
  for (const auto& entry : next) {
    if (!seen.insert(entry.first).second) continue;
    std::vector<int> part(1, entry.first);
    double length = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (int v : next.at(part[i])) {
        length += 0.5 * (mesh.V.row(v) - mesh.V.row(part[i])).norm();
        if (seen.insert(v).second) part.push_back(v);
      }
    }
    if (length < least) noise.insert(part.begin(), part.end());
  }
  sharp.erase(std::remove_if(sharp.begin(), sharp.end(),
                             [&](const auto& pair) { return noise.count(pair[0]) != 0; }),
              sharp.end());
  return rows_of(sharp);
}

std::vector<FeatureLine> feature_lines(const Edges& edges, const std::vector<char>& is_end) {
  const Neighbours next = neighbours_of(edges);
  const auto ends = [&](int v) { return is_end[v] || next.at(v).size() != 2; };
  std::set<std::array<int, 2>> done;
  std::vector<FeatureLine> lines;
  const auto follow = [&](int from, int to) {
    if (done.count({std::min(from, to), std::max(from, to)})) return;
    FeatureLine line{{from}, false};
    const int start = from;
    for (;;) {
      done.insert({std::min(from, to), std::max(from, to)});
      if (to == start && !ends(to)) {
        line.closed = true;
        break;
      }
      line.vertices.push_back(to);
      if (ends(to)) break;
      const std::vector<int>& both = next.at(to);
      const int on = both[0] == from ? both[1] : both[0];
      from = to;
      to = on;
    }
    lines.push_back(std::move(line));
  };
  for (const auto& [v, list] : next) {
    if (!ends(v)) continue;
    for (int to : list) follow(v, to);
  }
  for (const auto& [v, list] : next) follow(v, list.front());  // what is left has no end
  return lines;
}

}  // namespace curveups
