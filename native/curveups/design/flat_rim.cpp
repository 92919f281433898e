// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/flat_rim.hpp"

#include <algorithm>

#include "curveups/core/sort_unique.hpp"
#include "curveups/geometry/overlapping_boxes.hpp"

namespace curveups {
namespace {

using RimEdge = std::array<int, 2>;  // rows of corners

// Edges of tiles without contact, and sides of strips that end at open vertices.
std::vector<RimEdge> rim_edges(const TileMesh& tiles) {
  const std::vector<char> open = open_vertices(tiles);
  std::vector<std::array<char, 3>> touches(tiles.tile_count(), {0, 0, 0});
  std::vector<RimEdge> rim;
  for (const Contact& contact : tiles.contacts) {
    for (const int end : {0, 1}) {
      const int i = contact.tile[end], t = contact.side[end];
      const int j = contact.tile[1 - end], u = contact.side[1 - end];
      touches[i][t] = 1;
      if (open[tiles.mesh.F(i, t)]) rim.push_back({3 * i + t, 3 * j + next3(u)});
    }
  }
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      if (!touches[i][t]) rim.push_back({3 * i + t, 3 * i + next3(t)});
    }
  }
  return rim;
}

bool cross(const Points2& at, const RimEdge& e, const RimEdge& f) {
  if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) return false;
  const Vec2 a = at.row(e[0]), b = at.row(e[1]), c = at.row(f[0]), d = at.row(f[1]);
  const Vec2 ab = b - a, cd = d - c;
  return wedge(ab, c - a) * wedge(ab, d - a) < 0 && wedge(cd, a - c) * wedge(cd, b - c) < 0;
}

}  // namespace

std::vector<char> open_vertices(const TileMesh& tiles) {
  std::vector<char> open(tiles.mesh.V.rows(), 1);
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) open[tiles.mesh.F(i, t)] = 0;
  }
  for (std::size_t e = 0; e < tiles.topology.edges.size(); ++e) {
    const MeshEdge& edge = tiles.topology.edges[e];
    if (edge.boundary() || tiles.cut[e]) open[edge.v[0]] = open[edge.v[1]] = 1;
  }
  return open;
}

std::vector<std::vector<int>> corners_around_inner_vertices(const TileMesh& tiles) {
  std::vector<char> done = open_vertices(tiles);
  std::vector<std::vector<int>> around(tiles.mesh.V.rows());
  for (int i = 0; i < tiles.tile_count(); ++i) {
    for (int t = 0; t < 3; ++t) {
      const int v = tiles.mesh.F(i, t);
      if (done[v]) continue;
      done[v] = 1;
      int tile = i, corner = t;
      do {
        around[v].push_back(3 * tile + corner);
        // Across the edge that ends in v: the next tile counter-clockwise.
        tile = tiles.topology.neighbour(tile, prev3(corner));
        corner = 0;
        while (tiles.mesh.F(tile, corner) != v) ++corner;
      } while (tile != i);
    }
  }
  return around;
}

std::vector<std::array<int, 2>> crossing_rims(const TileMesh& tiles, const Points2& corners) {
  const std::vector<RimEdge> rim = rim_edges(tiles);
  std::vector<Eigen::AlignedBox3d> boxes(rim.size());
  for (std::size_t k = 0; k < rim.size(); ++k) {
    for (int c : rim[k]) boxes[k].extend(Vec3(corners(c, 0), corners(c, 1), 0));
  }
  std::vector<std::array<int, 2>> out;
  for (const auto& [k, l] : overlapping_boxes(boxes)) {
    if (!cross(corners, rim[k], rim[l])) continue;
    const auto [i, j] = std::minmax({rim[k][0] / 3, rim[l][0] / 3});
    out.push_back({i, j});
  }
  sort_unique(out);
  return out;
}

}  // namespace curveups
