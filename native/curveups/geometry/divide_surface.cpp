// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/geometry/divide_surface.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>

#include "curveups/core/errors.hpp"
#include "curveups/geometry/cut_graph.hpp"
#include "curveups/geometry/cut_mesh.hpp"
#include "curveups/geometry/edge_paths.hpp"
#include "curveups/geometry/face_regions.hpp"

namespace curveups {
namespace {

using Pair = std::array<int, 2>;
using Pairs = std::set<Pair>;  // vertices of edges, the lower first

Pair pair_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

std::vector<char> either(const std::vector<char>& a, const std::vector<char>& b) {
  std::vector<char> out = a;
  for (std::size_t e = 0; e < b.size(); ++e) out[e] = out[e] || b[e];
  return out;
}

// Shortest paths inside of a piece that join its loops along borders to one.
void join_loops(const MeshPiece& piece, const Pairs& borders, Pairs& slits) {
  const int count = static_cast<int>(piece.mesh.V.rows());
  const MeshTopology topology = build_topology(piece.mesh.F, count);
  std::vector<std::vector<int>> loops;
  for (std::vector<int>& loop : boundary_loops(topology)) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int a = loop[k], b = loop[(k + 1) % loop.size()];
      if (!borders.count(pair_of(piece.original[a], piece.original[b]))) continue;
      loops.push_back(std::move(loop));
      break;
    }
  }
  if (loops.size() < 2) return;
  std::vector<double> length = edge_lengths(piece.mesh, topology);
  for (std::size_t e = 0; e < length.size(); ++e) {
    if (topology.edges[e].boundary()) length[e] = std::numeric_limits<double>::infinity();
  }
  std::vector<int> joined = loops.front();
  loops.erase(loops.begin());
  while (!loops.empty()) {
    const PathTree tree = shortest_paths(topology, length, count, joined);
    std::size_t nearest = 0;
    int end = loops.front().front();
    for (std::size_t l = 0; l < loops.size(); ++l) {
      for (int v : loops[l]) {
        if (!(tree.distance[v] < tree.distance[end])) continue;
        nearest = l;
        end = v;
      }
    }
    const std::vector<int> path = tree.path_to(end);
    for (std::size_t k = 1; k < path.size(); ++k) {
      slits.insert(pair_of(piece.original[path[k - 1]], piece.original[path[k]]));
    }
    joined.insert(joined.end(), path.begin(), path.end());
    joined.insert(joined.end(), loops[nearest].begin(), loops[nearest].end());
    loops.erase(loops.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
}

}  // namespace

SurfaceDivision divide_surface(const TriangleMesh& mesh, const MeshTopology& topology,
                               const std::vector<char>& cut, int count) {
  const int faces = static_cast<int>(mesh.F.rows());
  if (count < 1 || (count > 1 && count > faces / least_faces_of_piece)) {
    throw InvalidInput(
        std::to_string(faces) + " tiles are too few for " + std::to_string(count) + " pieces",
        "ask for fewer pieces, or lower L");
  }
  SurfaceDivision out;
  out.piece = pieces_of_faces(topology, cut);
  Pairs borders, slits;
  if (1 + *std::max_element(out.piece.begin(), out.piece.end()) < count) {
    const std::vector<int> region = face_regions(mesh, topology, cut, count);
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      const MeshEdge& edge = topology.edges[e];
      if (edge.boundary() || (!cut.empty() && cut[e])) continue;
      if (region[edge.face[0]] != region[edge.face[1]]) {
        borders.insert(pair_of(edge.v[0], edge.v[1]));
      }
    }
  }
  out.borders = rows_of(borders);
  std::vector<char> all = either(mark_cuts(topology, out.borders), cut);
  out.piece = pieces_of_faces(topology, all);
  for (const MeshPiece& piece : cut_into_pieces(mesh, topology, all)) {
    join_loops(piece, borders, slits);
  }
  all = either(all, mark_cuts(topology, rows_of(slits)));
  const Edges opening = opening_cuts(mesh, topology, all);
  for (Eigen::Index e = 0; e < opening.rows(); ++e) {
    slits.insert(pair_of(opening(e, 0), opening(e, 1)));
  }
  out.slits = rows_of(slits);
  return out;
}

}  // namespace curveups
