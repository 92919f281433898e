// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/edge_paths.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {

std::vector<int> PathTree::path_to(int vertex) const {
  std::vector<int> path(1, vertex);
  while (before[path.back()] >= 0) path.push_back(before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

PathTree shortest_paths(const MeshTopology& topology, const std::vector<double>& length,
                        int vertex_count, const std::vector<int>& sources) {
  struct Step {
    int vertex;
    double length;
  };
  std::vector<std::vector<Step>> steps(vertex_count);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    if (std::isinf(length[e])) continue;
    const MeshEdge& edge = topology.edges[e];
    steps[edge.v[0]].push_back({edge.v[1], length[e]});
    steps[edge.v[1]].push_back({edge.v[0], length[e]});
  }
  PathTree tree{std::vector<double>(vertex_count, std::numeric_limits<double>::infinity()),
                std::vector<int>(vertex_count, -1)};
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue;
  for (int source : sources) {
    tree.distance[source] = 0;
    queue.emplace(0.0, source);
  }
  while (!queue.empty()) {
    const auto [reached, v] = queue.top();
    queue.pop();
    if (reached > tree.distance[v]) continue;
    for (const Step& step : steps[v]) {
      const double candidate = reached + step.length;
      if (candidate < tree.distance[step.vertex]) {
        tree.distance[step.vertex] = candidate;
        tree.before[step.vertex] = v;
        queue.emplace(candidate, step.vertex);
      }
    }
  }
  return tree;
}

std::vector<int> shortest_edge_path(const TriangleMesh& mesh, const Points3& points) {
  if (points.rows() == 0) throw InvalidInput("the polyline has no points", "give two or more");
  const int vertex_count = static_cast<int>(mesh.V.rows());
  const MeshTopology topology = build_topology(mesh.F);
  const std::vector<double> length = edge_lengths(mesh, topology);
  std::vector<char> used(vertex_count, 0);
  for (int i = 0; i < mesh.F.size(); ++i) used[mesh.F.data()[i]] = 1;
  std::vector<int> path;
  for (int i = 0; i < points.rows(); ++i) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < vertex_count; ++v) {
      const double squared = (mesh.V.row(v) - points.row(i)).squaredNorm();
      if (used[v] && squared < least) {
        least = squared;
        nearest = v;
      }
    }
    if (path.empty()) {
      path.push_back(nearest);
      continue;
    }
    const PathTree tree = shortest_paths(topology, length, vertex_count, {path.back()});
    if (std::isinf(tree.distance[nearest])) {
      throw TopologyError("no path of edges joins points " + std::to_string(i) + " and " +
                              std::to_string(i + 1) + " of the polyline",
                          "keep each polyline on one component");
    }
    const std::vector<int> leg = tree.path_to(nearest);
    path.insert(path.end(), leg.begin() + 1, leg.end());
  }
  return path;
}

}  // namespace curveups
