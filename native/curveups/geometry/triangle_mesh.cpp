// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"

namespace curveups {

UsedPart used_part(const Points3& V, Triangles F) {
  UsedPart out;
  out.number.assign(V.rows(), -1);
  for (int& v : F.reshaped<Eigen::RowMajor>()) out.number[v] = 0;
  int count = 0;
  for (int& n : out.number) n = n < 0 ? -1 : count++;
  out.mesh.V.resize(count, 3);
  for (int v = 0; v < V.rows(); ++v) {
    if (out.number[v] >= 0) out.mesh.V.row(out.number[v]) = V.row(v);
  }
  for (int& v : F.reshaped<Eigen::RowMajor>()) v = out.number[v];
  out.mesh.F = std::move(F);
  return out;
}

MeshTopology build_topology(const Triangles& F) {
  const int face_count = static_cast<int>(F.rows());
  MeshTopology topology;
  topology.edge_of.setConstant(face_count, 3, -1);
  topology.neighbour.setConstant(face_count, 3, -1);
  std::unordered_map<std::uint64_t, int> index;
  index.reserve(face_count * 2);
  std::vector<int> crowded, twisted;
  for (int f = 0; f < face_count; ++f) {
    checkpoint_now_and_then(f);
    for (int t = 0; t < 3; ++t) {
      const int a = F(f, t), b = F(f, next3(t));
      if (a == b) {
        throw TopologyError("face " + std::to_string(f + 1) + " uses a vertex twice",
                            "remove degenerate faces", {f});
      }
      const auto [it, fresh] =
          index.emplace(edge_key(a, b), static_cast<int>(topology.edges.size()));
      if (fresh) {
        topology.edges.push_back({{a, b}, {f, -1}, {t, -1}});
      } else {
        MeshEdge& edge = topology.edges[it->second];
        if (edge.face[1] >= 0) {
          crowded.push_back(f);
          continue;
        }
        if (edge.v[0] == a) {
          twisted.push_back(f);
          continue;
        }
        edge.face[1] = f;
        edge.side[1] = t;
        topology.neighbour(f, t) = edge.face[0];
        topology.neighbour(edge.face[0], edge.side[0]) = f;
      }
      topology.edge_of(f, t) = it->second;
    }
  }
  if (!crowded.empty()) {
    throw TopologyError(
        std::to_string(crowded.size()) + " edges have more than two faces (non-manifold)",
        "remove duplicate and inner faces", crowded);
  }
  if (!twisted.empty()) {
    throw TopologyError("neighbouring faces are oriented differently at " +
                            std::to_string(twisted.size()) +
                            " edges (or the surface has one side only)",
                        "make the normals consistent", twisted);
  }
  return topology;
}

std::vector<char> boundary_vertices(const MeshTopology& topology, Eigen::Index vertex_count) {
  std::vector<char> marked(vertex_count, 0);
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) marked[edge.v[0]] = marked[edge.v[1]] = 1;
  }
  return marked;
}

std::vector<std::vector<int>> boundary_loops(const MeshTopology& topology) {
  std::unordered_map<int, std::array<int, 2>> next;  // vertex -> next vertex, face
  std::vector<int> starts;
  for (const MeshEdge& edge : topology.edges) {
    if (!edge.boundary()) continue;
    const bool fresh = next.emplace(edge.v[0], std::array<int, 2>{edge.v[1], edge.face[0]}).second;
    if (!fresh) {
      throw TopologyError("the boundary touches itself in vertex " + std::to_string(edge.v[0]),
                          "split that vertex or fill the hole", {next[edge.v[0]][1], edge.face[0]});
    }
    starts.push_back(edge.v[0]);
  }
  std::vector<std::vector<int>> loops;
  for (int start : starts) {
    if (next.find(start) == next.end()) continue;
    std::vector<int> loop;
    for (auto it = next.find(start); it != next.end(); it = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(start);
      const int to = it->second[0];
      next.erase(it);
      if (to == start) break;
      loop.push_back(to);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

int handle_count(const MeshTopology& topology, int loop_count) {
  std::unordered_set<int> vertices;
  for (const MeshEdge& edge : topology.edges) vertices.insert(edge.v, edge.v + 2);
  const int euler = static_cast<int>(vertices.size()) - static_cast<int>(topology.edges.size()) +
                    static_cast<int>(topology.neighbour.rows());
  return (2 - loop_count - euler) / 2;
}

std::vector<int> face_components(const MeshTopology& topology, const std::vector<char>& joined) {
  const int face_count = static_cast<int>(topology.neighbour.rows());
  std::vector<int> component(face_count, -1), stack;
  int count = 0;
  for (int f = 0; f < face_count; ++f) {
    if (component[f] >= 0) continue;
    component[f] = count;
    stack.assign(1, f);
    while (!stack.empty()) {
      const int g = stack.back();
      stack.pop_back();
      for (int t = 0; t < 3; ++t) {
        const int h = topology.neighbour(g, t);
        if (h < 0 || component[h] >= 0) continue;
        if (!joined.empty() && !joined[topology.edge_of(g, t)]) continue;
        component[h] = count;
        stack.push_back(h);
      }
    }
    ++count;
  }
  return component;
}

std::vector<double> edge_lengths(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<double> length;
  for (const MeshEdge& edge : topology.edges) {
    length.push_back((mesh.V.row(edge.v[1]) - mesh.V.row(edge.v[0])).norm());
  }
  return length;
}

double loop_length(const Points3& V, const std::vector<int>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (V.row(loop[(i + 1) % loop.size()]) - V.row(loop[i])).norm();
  }
  return length;
}

double mean_edge_length(const TriangleMesh& mesh) {
  const std::vector<double> length = edge_lengths(mesh, build_topology(mesh.F));
  const double sum = std::accumulate(length.begin(), length.end(), 0.0);
  return length.empty() ? 0.0 : sum / static_cast<double>(length.size());
}

Vec3 face_area_vector(const TriangleMesh& mesh, int face) {
  const Vec3 a = mesh.V.row(mesh.F(face, 0)), b = mesh.V.row(mesh.F(face, 1)),
             c = mesh.V.row(mesh.F(face, 2));
  return 0.5 * (b - a).cross(c - a);
}

double surface_area(const TriangleMesh& mesh) {
  double area = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) area += face_area_vector(mesh, f).norm();
  return area;
}

}  // namespace curveups
