// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/design.hpp"

#include <cmath>
#include <string>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/parameter_texts.hpp"
#include "curveups/design/remote_overlaps.hpp"

namespace curveups {

DesignGeometry make_geometry(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters) {
  DesignGeometry geometry;
  geometry.tiles = make_tile_mesh(mesh, cuts, parameters.H_body);
  const std::vector<int> held = listed_tiles(parameters.held_tiles);
  if (!held.empty() && held.back() >= geometry.tiles.tile_count()) {
    throw InvalidInput("held_tiles names " + tile_name(held.back()) + ", but there are " +
                           std::to_string(geometry.tiles.tile_count()) + " tiles",
                       "name tiles of this design");
  }
  require_back_faces(geometry.tiles);
  geometry.truncation = truncate_at_vertices(geometry.tiles);
  checkpoint();
  geometry.patches = compute_contact_patches(geometry.tiles, geometry.truncation);
  checkpoint();
  separate_remote_tiles(geometry.tiles, geometry.patches, geometry.truncation);
  separate_remote_front_pins(geometry.tiles, parameters.H_pin, geometry.truncation);
  checkpoint();
  geometry.pin_bounds = compute_pin_bounds(geometry.tiles, geometry.truncation, parameters);
  return geometry;
}

double flat_area(const DesignGeometry& geometry, const FlatCorners& corners) {
  const TileMesh& tiles = geometry.tiles;
  const MeshTopology& topology = tiles.topology;
  auto corner = [&](int tile, int t) -> Vec2 { return corners.row(tile).segment<2>(2 * t); };
  double area = tiles.area.sum();
  for (const Contact& contact : tiles.contacts) {
    const int i = contact.tile[0], t = contact.side[0], j = contact.tile[1], u = contact.side[1];
    // Counter-clockwise: along tile i's edge backwards, along tile j's edge backwards.
    const Vec2 a = corner(i, next3(t)), b = corner(i, t), c = corner(j, next3(u)), d = corner(j, u);
    area += 0.5 * wedge(c - a, d - b);
  }
  // Vertices all of whose edges are uncut and interior: once round through the neighbours.
  const int vertex_count = static_cast<int>(tiles.mesh.V.rows());
  std::vector<int> start(vertex_count, -1);
  std::vector<char> open(vertex_count, 0);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.boundary() || tiles.cut[e]) open[edge.v[0]] = open[edge.v[1]] = 1;
  }
  for (int i = tiles.tile_count() - 1; i >= 0; --i) {
    for (int t = 0; t < 3; ++t) start[tiles.mesh.F(i, t)] = 3 * i + t;
  }
  for (int v = 0; v < vertex_count; ++v) {
    if (open[v] || start[v] < 0) continue;
    int i = start[v] / 3, t = start[v] % 3;
    Vec2 previous = corner(i, t);
    const Vec2 first = previous;
    do {
      // Across the edge that ends in v: the next tile counter-clockwise.
      const int next = topology.neighbour(i, prev3(t));
      i = next;
      t = 0;
      while (tiles.mesh.F(i, t) != v) ++t;
      const Vec2 here = corner(i, t);
      area += 0.5 * wedge(previous - first, here - first);
      previous = here;
    } while (3 * i + t != start[v]);
  }
  return area;
}

}  // namespace curveups
