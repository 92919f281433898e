// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/cut_graph.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "curveups/core/disjoint_sets.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/edge_paths.hpp"

namespace curveups {
namespace {

using EdgeSet = std::set<std::array<int, 2>>;  // vertex pairs, ascending

void add_path(const std::vector<int>& path, EdgeSet& out) {
  for (std::size_t k = 1; k < path.size(); ++k) {
    out.insert({std::min(path[k - 1], path[k]), std::max(path[k - 1], path[k])});
  }
}

// Path from one end of the surface to the other: the vertex farthest from the first, and the vertex
// farthest from that.
std::vector<int> longest_path(const TriangleMesh& mesh, const MeshTopology& topology) {
  const std::vector<double> length = edge_lengths(mesh, topology);
  const int count = static_cast<int>(mesh.V.rows());
  int end = mesh.F(0, 0);
  std::vector<int> path;
  for (int sweep = 0; sweep < 2; ++sweep) {
    const PathTree tree = shortest_paths(topology, length, count, {end});
    end = static_cast<int>(std::max_element(tree.distance.begin(), tree.distance.end()) -
                           tree.distance.begin());
    path = tree.path_to(end);
  }
  if (path.size() < 3) {
    // A slit of one edge opens nothing: neighbours are joined over the third corner of a face.
    for (int i = 0; i < mesh.F.size(); ++i) {
      const int f = i / 3, t = i % 3, a = mesh.F(f, t), b = mesh.F(f, next3(t));
      if (a == path.front() && b == path.back()) return {a, mesh.F(f, prev3(t)), b};
    }
  }
  return path;
}

// Arcs from boundary to boundary, the shortest first, that together cut the piece into a disc.
std::vector<EdgeSet> disc_arcs(const TriangleMesh& mesh, const MeshTopology& topology) {
  const std::vector<double> length = edge_lengths(mesh, topology);
  std::vector<int> boundary;
  for (const MeshEdge& edge : topology.edges) {
    if (edge.boundary()) boundary.push_back(edge.v[0]);
  }
  const PathTree tree = shortest_paths(topology, length, static_cast<int>(mesh.V.rows()), boundary);
  struct Arc {
    double length;
    int edge;
  };
  std::vector<Arc> open;  // interior edges outside the tree of paths
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    const int a = edge.v[0], b = edge.v[1];
    if (edge.boundary() || tree.before[a] == b || tree.before[b] == a) continue;
    open.push_back({tree.distance[a] + length[e] + tree.distance[b], static_cast<int>(e)});
  }
  // A spanning tree of the faces across the longest of them; the others remain.
  std::stable_sort(open.begin(), open.end(),
                   [](const Arc& a, const Arc& b) { return a.length > b.length; });
  DisjointSets joined(mesh.F.rows());
  std::vector<EdgeSet> arcs;
  for (const Arc& arc : open) {
    const MeshEdge& edge = topology.edges[arc.edge];
    if (joined.unite(edge.face[0], edge.face[1])) continue;
    EdgeSet edges;
    add_path({edge.v[0], edge.v[1]}, edges);
    for (int end : edge.v) add_path(tree.path_to(end), edges);
    arcs.push_back(std::move(edges));
  }
  std::reverse(arcs.begin(), arcs.end());
  return arcs;
}

bool has_handles(const TriangleMesh& mesh, const MeshTopology& topology, const EdgeSet& cut) {
  const TriangleMesh open = cut_open(mesh, topology, mark_cuts(topology, rows_of(cut))).mesh;
  const MeshTopology cut_topology = build_topology(open.F);
  return handle_count(cut_topology, static_cast<int>(boundary_loops(cut_topology).size())) > 0;
}

EdgeSet joined(const std::vector<EdgeSet>& sets, std::size_t without) {
  EdgeSet out;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (k != without) out.insert(sets[k].begin(), sets[k].end());
  }
  return out;
}

EdgeSet handle_cuts(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::vector<EdgeSet> arcs = disc_arcs(mesh, topology);
  for (std::size_t k = arcs.size(); k-- > 0;) {  // the longest first
    if (!has_handles(mesh, topology, joined(arcs, k))) {
      arcs.erase(arcs.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  return joined(arcs, arcs.size());
}

}  // namespace

Edges opening_cuts(const TriangleMesh& mesh, const MeshTopology& topology,
                   const std::vector<char>& cut) {
  EdgeSet cuts;
  auto keep = [&](const std::vector<MeshPiece>& pieces, const auto& cuts_of) {
    for (const MeshPiece& piece : pieces) {
      const MeshTopology own = build_topology(piece.mesh.F);
      for (const auto& edge : cuts_of(piece.mesh, own)) {
        add_path({piece.original[edge[0]], piece.original[edge[1]]}, cuts);
      }
    }
  };
  keep(cut_into_pieces(mesh, topology, cut), [](const TriangleMesh& piece, const auto& own) {
    EdgeSet slit;
    if (boundary_loops(own).empty()) add_path(longest_path(piece, own), slit);
    return slit;
  });
  std::vector<char> all = mark_cuts(topology, rows_of(cuts));
  for (std::size_t e = 0; e < cut.size(); ++e) all[e] = all[e] || cut[e];
  keep(cut_into_pieces(mesh, topology, all), [](const TriangleMesh& piece, const auto& own) {
    const int loops = static_cast<int>(boundary_loops(own).size());
    return handle_count(own, loops) > 0 ? handle_cuts(piece, own) : EdgeSet();
  });
  return rows_of(cuts);
}

}  // namespace curveups
