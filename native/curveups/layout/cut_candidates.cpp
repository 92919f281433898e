// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/layout/cut_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/edge_paths.hpp"

namespace curveups {
namespace {

constexpr int max_tips = 5, max_basins = 2, max_weak = 3, max_holes = 2;
constexpr int rings = 3;             // edges to all vertices that an extreme exceeds
constexpr double least_depth = 0.1;  // of an extreme: log scale off the mean

// A piece of the cut mesh with data for all its candidates.
struct Piece {
  const TileMesh& tiles;
  MeshPiece part;
  MeshTopology topology;
  std::vector<std::vector<int>> loops;
  std::vector<char> on_boundary;
  std::vector<std::vector<int>> neighbours;  // per vertex, ascending
  std::vector<int> tile_at;                  // per vertex: the lowest tile around it
  std::vector<double> length;                // per edge
  PathTree to_boundary;

  Piece(const TileMesh& all, MeshPiece&& piece)
      : tiles(all),
        part(std::move(piece)),
        topology(build_topology(part.mesh.F)),
        loops(boundary_loops(topology)),
        on_boundary(part.mesh.V.rows(), 0),
        neighbours(part.mesh.V.rows()),
        tile_at(part.mesh.V.rows(), -1),
        length(edge_lengths(part.mesh, topology)) {
    std::vector<int> sources;
    for (const auto& loop : loops) {
      for (int v : loop) {
        on_boundary[v] = 1;
        sources.push_back(v);
      }
    }
    for (const MeshEdge& edge : topology.edges) {
      neighbours[edge.v[0]].push_back(edge.v[1]);
      neighbours[edge.v[1]].push_back(edge.v[0]);
    }
    for (auto& list : neighbours) std::sort(list.begin(), list.end());
    for (int i = 0; i < part.mesh.F.size(); ++i) {
      int& tile = tile_at[part.mesh.F.data()[i]];
      if (tile < 0) tile = part.faces[i / 3];
    }
    to_boundary = shortest_paths(topology, length, vertex_count(), sources);
  }

  int vertex_count() const { return static_cast<int>(part.mesh.V.rows()); }

  // All vertices at most `count` edges away.
  std::vector<int> around(int vertex, int count) const {
    std::vector<int> reached(1, vertex);
    std::size_t begin = 0;
    for (int ring = 0; ring < count; ++ring) {
      const std::size_t end = reached.size();
      for (std::size_t k = begin; k < end; ++k) {
        for (int n : neighbours[reached[k]]) {
          if (std::find(reached.begin(), reached.end(), n) == reached.end()) reached.push_back(n);
        }
      }
      begin = end;
    }
    return reached;
  }

  CutCandidate along(const std::vector<int>& path, Finding reason) const {
    CutCandidate out;
    out.edges.resize(static_cast<Eigen::Index>(path.size()) - 1, 2);
    for (std::size_t k = 1; k < path.size(); ++k) {
      out.edges.row(static_cast<Eigen::Index>(k) - 1) << part.original[path[k - 1]],
          part.original[path[k]];
    }
    out.length = length_of(tiles.mesh, out.edges);
    out.reason = std::move(reason);
    return out;
  }
};

// A candidate and the strength of its reason.
struct Place {
  double strength;
  CutCandidate candidate;
};

void keep_strongest(std::vector<Place>& places, int most, std::vector<CutCandidate>& out) {
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.strength > b.strength; });
  for (int k = 0; k < std::min<int>(most, static_cast<int>(places.size())); ++k) {
    out.push_back(std::move(places[k].candidate));
  }
}

void find_extremes(const Piece& piece, const Eigen::VectorXd& scale, std::vector<Place>& tips,
                   std::vector<Place>& basins) {
  const int count = piece.vertex_count();
  std::vector<double> value(count, 0), area(count, 0);
  for (int i = 0; i < piece.part.mesh.F.size(); ++i) {
    const int v = piece.part.mesh.F.data()[i], tile = piece.part.faces[i / 3];
    value[v] += piece.tiles.area[tile] * std::log(scale[tile]);
    area[v] += piece.tiles.area[tile];
  }
  for (int v = 0; v < count; ++v) value[v] /= area[v];
  for (int v = 0; v < count; ++v) {
    if (piece.on_boundary[v] || std::abs(value[v]) < least_depth) continue;
    bool least = value[v]<0, largest = value[v]> 0;
    for (int n : piece.around(v, rings)) {
      if (n == v || piece.on_boundary[n]) continue;
      least = least && (value[v] < value[n] || (value[v] == value[n] && v < n));
      largest = largest && (value[v] > value[n] || (value[v] == value[n] && v < n));
    }
    if (!least && !largest) continue;
    const std::vector<int> tile = {piece.tile_at[v]};
    (least ? tips : basins)
        .push_back(
            {std::abs(value[v]), piece.along(piece.to_boundary.path_to(v),
                                             {least ? "cut.tip" : "cut.saddle",
                                              tile,
                                              {{"tile", tile}, {"scale", std::exp(value[v])}}})});
  }
}

// Weak contacts in this piece: the cut has the contact's own edge.
void find_weak(const Piece& piece, const std::vector<std::array<int, 2>>& weak,
               std::vector<Place>& places) {
  std::vector<char> taken(piece.vertex_count(), 0);
  for (const MeshEdge& edge : piece.topology.edges) {
    if (edge.boundary()) continue;
    const std::array<int, 2> pair = {piece.part.faces[edge.face[0]],
                                     piece.part.faces[edge.face[1]]};
    const bool named = std::any_of(weak.begin(), weak.end(), [&](const std::array<int, 2>& w) {
      return (w[0] == pair[0] && w[1] == pair[1]) || (w[0] == pair[1] && w[1] == pair[0]);
    });
    const int a = edge.v[0], b = edge.v[1];
    if (!named || taken[a] || taken[b] || (piece.on_boundary[a] && piece.on_boundary[b])) continue;
    const bool towards_a = piece.to_boundary.distance[a] <= piece.to_boundary.distance[b];
    const int near = towards_a ? a : b, far = towards_a ? b : a;  // far is no boundary vertex
    std::vector<int> path = piece.to_boundary.path_to(near);
    path.push_back(far);
    for (int v : piece.around(far, rings)) taken[v] = 1;
    places.push_back(
        {piece.to_boundary.distance[far],
         piece.along(path,
                     {"cut.weak_contact", tiles_of({pair}), {{"contact", Finding::Pairs{pair}}}})});
  }
}

// Each loop but the longest: the shortest path to another one.
void find_holes(const Piece& piece, std::vector<Place>& places) {
  std::vector<double> round;
  for (const std::vector<int>& loop : piece.loops) {
    round.push_back(loop_length(piece.part.mesh.V, loop));
  }
  const std::size_t outer =
      static_cast<std::size_t>(std::max_element(round.begin(), round.end()) - round.begin());
  for (std::size_t l = 0; l < piece.loops.size(); ++l) {
    if (l == outer) continue;
    const PathTree tree =
        shortest_paths(piece.topology, piece.length, piece.vertex_count(), piece.loops[l]);
    int nearest = -1;
    for (std::size_t m = 0; m < piece.loops.size(); ++m) {
      if (m == l) continue;
      for (int v : piece.loops[m]) {
        if (nearest < 0 || tree.distance[v] < tree.distance[nearest]) nearest = v;
      }
    }
    const std::vector<int> path = tree.path_to(nearest);
    const std::vector<int> tile = {piece.tile_at[path.front()]};
    places.push_back({round[l], piece.along(path, {"cut.hole", tile, {{"tile", tile}}})});
  }
}

}  // namespace

double length_of(const TriangleMesh& mesh, const Edges& edges) {
  double sum = 0;
  for (Eigen::Index e = 0; e < edges.rows(); ++e) {
    sum += (mesh.V.row(edges(e, 1)) - mesh.V.row(edges(e, 0))).norm();
  }
  return sum;
}

std::vector<CutCandidate> cut_candidates(const TileMesh& tiles, const Eigen::VectorXd& scale,
                                         const std::vector<std::array<int, 2>>& weak) {
  std::vector<Place> contacts, tips, basins, holes;
  for (MeshPiece& part : cut_into_pieces(tiles.mesh, tiles.topology, tiles.cut)) {
    const Piece piece(tiles, std::move(part));
    find_weak(piece, weak, contacts);
    find_extremes(piece, scale, tips, basins);
    find_holes(piece, holes);
  }
  std::vector<CutCandidate> out;
  keep_strongest(contacts, max_weak, out);
  keep_strongest(tips, max_tips, out);
  keep_strongest(basins, max_basins, out);
  keep_strongest(holes, max_holes, out);
  return out;
}

}  // namespace curveups
