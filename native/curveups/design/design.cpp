// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/design.hpp"

#include <string>
#include <utility>

#include "curveups/core/checkpoint.hpp"
#include "curveups/core/errors.hpp"
#include "curveups/design/flat_rim.hpp"
#include "curveups/design/remote_overlaps.hpp"

namespace curveups {

DesignGeometry make_geometry(const TriangleMesh& mesh, const Edges& cuts,
                             const Parameters& parameters) {
  TileMesh tiles = make_tile_mesh(mesh, cuts, parameters.H_body);
  const std::vector<int> held = listed_tiles(parameters.held_tiles);
  if (!held.empty() && held.back() >= tiles.tile_count()) {
    throw InvalidInput("held_tiles names " + tile_name(held.back()) + ", but there are " +
                           std::to_string(tiles.tile_count()) + " tiles",
                       "name tiles of this design");
  }
  require_back_faces(tiles);
  return make_geometry(std::move(tiles), parameters);
}

DesignGeometry make_geometry(TileMesh tiles, const Parameters& parameters) {
  DesignGeometry geometry;
  geometry.tiles = std::move(tiles);
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
  const Eigen::Map<const Points2> corner(corners.data(), 3 * corners.rows(), 2);
  double area = tiles.area.sum();
  // Quadrilateral a, b, c, d, counter-clockwise; a triangle where a is b.
  auto add = [&](int a, int b, int c, int d) {
    const Vec2 ac = corner.row(c) - corner.row(a), bd = corner.row(d) - corner.row(b);
    area += 0.5 * wedge(ac, bd);
  };
  for (const Contact& contact : tiles.contacts) {
    const int i = contact.tile[0], t = contact.side[0], j = contact.tile[1], u = contact.side[1];
    // Along tile i's edge backwards, along tile j's edge backwards.
    add(3 * i + next3(t), 3 * i + t, 3 * j + next3(u), 3 * j + u);
  }
  for (const std::vector<int>& around : corners_around_inner_vertices(tiles)) {
    for (std::size_t k = 1; k + 1 < around.size(); ++k) {
      add(around[0], around[0], around[k], around[k + 1]);
    }
  }
  return area;
}

}  // namespace curveups
