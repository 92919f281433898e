// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/vertex_patch.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "curveups/core/sort_unique.hpp"
#include "curveups/design/remote_overlaps.hpp"

namespace curveups {
namespace {

// Place of an item in a sorted list that has it.
int place_of(int item, const std::vector<int>& sorted) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), item) - sorted.begin());
}

}  // namespace

VertexPatches::VertexPatches(const DesignGeometry& geometry)
    : geometry_(geometry), tiles_at_(tiles_at_vertices(geometry.tiles)) {
  const TileMesh& tiles = geometry.tiles;
  contact_of_.assign(3 * tiles.tile_count(), -1);
  for (std::size_t k = 0; k < tiles.contacts.size(); ++k) {
    for (int s = 0; s < 2; ++s) {
      contact_of_[3 * tiles.contacts[k].tile[s] + tiles.contacts[k].side[s]] = static_cast<int>(k);
    }
  }
}

std::vector<int> VertexPatches::tiles_around(const std::vector<int>& tiles) const {
  std::vector<int> out;
  for (int tile : tiles) {
    for (int t = 0; t < 3; ++t) {
      const std::vector<int>& here = tiles_at_[geometry_.tiles.mesh.F(tile, t)];
      out.insert(out.end(), here.begin(), here.end());
    }
  }
  sort_unique(out);
  return out;
}

VertexPatch VertexPatches::around(int vertex) const {
  const TileMesh& tiles = geometry_.tiles;
  const std::vector<int>& star = tiles_at_[vertex];
  // The vertex changes its tiles, through their folds the tiles across their edges, and through
  // truncation planes the interfaces that end at a vertex of either, which need all tiles there.
  std::vector<int> changed = star;
  for (int tile : star) {
    for (int t = 0; t < 3; ++t) {
      const int n = tiles.topology.neighbour(tile, t);
      if (n >= 0) changed.push_back(n);
    }
  }
  sort_unique(changed);
  VertexPatch out;
  const std::vector<int> near = tiles_around(changed);
  out.tiles = tiles_around(near);
  const int count = static_cast<int>(out.tiles.size());

  std::vector<int> vertices;
  for (int tile : out.tiles) {
    for (int t = 0; t < 3; ++t) vertices.push_back(tiles.mesh.F(tile, t));
  }
  sort_unique(vertices);
  auto local = [&](int v) { return place_of(v, vertices); };
  out.moving = local(vertex);
  out.mesh.V.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    out.mesh.V.row(v) = tiles.mesh.V.row(vertices[v]);
  }
  out.mesh.F.resize(count, 3);
  std::vector<std::array<int, 2>> cuts;
  out.remote = false;
  out.shaped = geometry_.shaped;
  out.H_body = tiles.H_body;
  for (int k = 0; k < count; ++k) {
    const int tile = out.tiles[k];
    if (std::binary_search(near.begin(), near.end(), tile)) out.near.push_back(k);
    if (std::binary_search(changed.begin(), changed.end(), tile)) {
      out.changed.push_back(k);
      for (int t = 0; t < 3; ++t) out.touched.push_back(local(tiles.mesh.F(tile, t)));
    }
    for (const TruncationPlane& plane : geometry_.truncation.of_tile[tile]) {
      out.remote = out.remote || plane.vertex < 0;
    }
    for (int t = 0; t < 3; ++t) {
      out.mesh.F(k, t) = local(tiles.mesh.F(tile, t));
      const int other = tiles.topology.neighbour(tile, t);
      // Each edge once, where its first tile names it: the order of TileMesh::contacts.
      if (other < tile || !std::binary_search(out.tiles.begin(), out.tiles.end(), other)) continue;
      if (tiles.cut[tiles.topology.edge_of(tile, t)]) {
        cuts.push_back({local(tiles.mesh.F(tile, t)), local(tiles.mesh.F(tile, next3(t)))});
        continue;
      }
      const bool inside = std::binary_search(near.begin(), near.end(), tile) &&
                          std::binary_search(near.begin(), near.end(), other);
      out.contacts.push_back(inside ? contact_of_[3 * tile + t] : -1);
    }
  }
  sort_unique(out.touched);
  out.fixed.of_tile.resize(count);
  out.fixed.front_pins.resize(count);
  auto keep = [&](const std::vector<TruncationPlane>& planes, std::vector<TruncationPlane>& fixed) {
    for (TruncationPlane plane : planes) {
      if (plane.vertex < 0) continue;
      plane.vertex = local(plane.vertex);
      plane.other = place_of(plane.other, out.tiles);
      if (!std::binary_search(out.touched.begin(), out.touched.end(), plane.vertex)) {
        fixed.push_back(plane);
      }
    }
  };
  for (int k : out.near) {
    keep(geometry_.truncation.of_tile[out.tiles[k]], out.fixed.of_tile[k]);
    keep(geometry_.truncation.front_pins[out.tiles[k]], out.fixed.front_pins[k]);
  }
  out.cuts.resize(static_cast<Eigen::Index>(cuts.size()), 2);
  for (std::size_t c = 0; c < cuts.size(); ++c) out.cuts.row(c) << cuts[c][0], cuts[c][1];
  return out;
}

LocalGeometry local_geometry(const VertexPatch& patch, const Vec3& position) {
  TriangleMesh mesh = patch.mesh;
  mesh.V.row(patch.moving) = position.transpose();
  LocalGeometry out;
  out.tiles = make_tile_mesh(mesh, patch.cuts, patch.H_body);
  out.truncation = patch.fixed;
  if (!patch.shaped) return out;
  truncate_at_vertices(out.tiles, patch.touched, out.truncation);
  out.patches = compute_contact_patches(out.tiles, out.truncation);
  if (patch.remote) separate_remote_tiles(out.tiles, out.patches, out.truncation);
  return out;
}

Eigen::MatrixXd derivatives_by_vertex(
    const VertexPatch& patch, const std::function<Eigen::VectorXd(const LocalGeometry&)>& measure) {
  // Shapes vary over millimetres: the error of the differences is some h^2, that of rounding
  // 1e-14 / h.
  constexpr double h = 1e-4;
  const Vec3 here = patch.mesh.V.row(patch.moving);
  Eigen::MatrixXd out;
  for (int axis = 0; axis < 3; ++axis) {
    auto at = [&](double step) {
      return measure(local_geometry(patch, here + step * h * Vec3::Unit(axis)));
    };
    const Eigen::VectorXd column = (at(1) - at(-1)) / (2 * h);
    if (out.size() == 0) out.resize(column.size(), 3);
    out.col(axis) = column;
  }
  return out;
}

}  // namespace curveups
