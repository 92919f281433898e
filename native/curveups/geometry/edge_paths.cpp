// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/edge_paths.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "curveups/core/errors.hpp"

namespace curveups {
namespace {

struct Step {
  int vertex;
  double length;
};

// From `from` to `to`, both included; empty where there is none. Of equally short paths the one
// that reaches its vertices from lower numbers.
std::vector<int> dijkstra(const std::vector<std::vector<Step>>& graph, int from, int to) {
  std::vector<double> distance(graph.size(), std::numeric_limits<double>::infinity());
  std::vector<int> before(graph.size(), -1);
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue;
  distance[from] = 0;
  queue.emplace(0.0, from);
  while (!queue.empty()) {
    const auto [reached, v] = queue.top();
    queue.pop();
    if (v == to) break;
    if (reached > distance[v]) continue;
    for (const Step& step : graph[v]) {
      const double candidate = reached + step.length;
      if (candidate < distance[step.vertex]) {
        distance[step.vertex] = candidate;
        before[step.vertex] = v;
        queue.emplace(candidate, step.vertex);
      }
    }
  }
  if (from != to && before[to] < 0) return {};
  std::vector<int> path(1, to);
  while (path.back() != from) path.push_back(before[path.back()]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

std::vector<int> shortest_edge_path(const TriangleMesh& mesh, const Points3& points) {
  if (points.rows() == 0) throw InvalidInput("the polyline has no points", "give two or more");
  if (!points.allFinite()) {
    throw InvalidInput("the polyline has a point that is not finite", "repair the cuts");
  }
  if (mesh.V.rows() == 0 || !mesh.V.allFinite()) {
    throw InvalidInput("the surface has no vertices, or some that are not finite",
                       "repair the file");
  }
  const MeshTopology topology = build_topology(mesh.F, static_cast<int>(mesh.V.rows()));
  std::vector<std::vector<Step>> graph(mesh.V.rows());
  for (const MeshEdge& edge : topology.edges) {
    const double length = (mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).norm();
    graph[edge.v[0]].push_back({edge.v[1], length});
    graph[edge.v[1]].push_back({edge.v[0], length});
  }
  std::vector<int> path;
  for (int i = 0; i < points.rows(); ++i) {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const double squared = (mesh.V.row(v) - points.row(i)).squaredNorm();
      if (!graph[v].empty() && squared < least) {
        least = squared;
        nearest = v;
      }
    }
    if (nearest < 0) throw InvalidInput("the surface has no faces", "check the input file");
    if (path.empty()) {
      path.push_back(nearest);
      continue;
    }
    const std::vector<int> leg = dijkstra(graph, path.back(), nearest);
    if (leg.empty()) {
      throw TopologyError("no path of edges joins points " + std::to_string(i) + " and " +
                              std::to_string(i + 1) + " of the polyline",
                          "keep each polyline on one component");
    }
    path.insert(path.end(), leg.begin() + 1, leg.end());
  }
  return path;
}

}  // namespace curveups
