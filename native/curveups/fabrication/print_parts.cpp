// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_parts.hpp"

#include <cstdio>
#include <limits>

#include "curveups/bodies/tile_print.hpp"
#include "curveups/core/parallel.hpp"

namespace curveups {

std::string numbered(const char* format, int a, int b) {
  char name[48];
  std::snprintf(name, sizeof name, format, a, b);
  return name;
}

std::array<Vec2, 2> front_edge(const PrintModel& model, const Contact& contact, int side) {
  const int tile = contact.tile[side], wall = contact.side[side];
  const std::array<Vec2, 3> corner = place(model.poses, tile, model.geometry.tiles.front[tile]);
  return {corner[wall], corner[next3(wall)]};
}

int nearest_tile(const PieceFootprint& footprint, const Vec2& place) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < footprint.tiles.size(); ++k) {
    for (const Vec2& corner : footprint.tiles[k]) {
      const double distance = (corner - place).norm();
      if (distance < least) nearest = footprint.rows[k], least = distance;
    }
  }
  return nearest;
}

std::vector<PrintBody> flat_tiles(const PrintModel& model, const std::vector<ConvexBody>& bodies,
                                  const std::vector<std::vector<WallCap>>& caps) {
  std::vector<PrintBody> out(bodies.size());
  parallel_for(static_cast<int>(bodies.size()), [&](int i) {
    out[i] = make_tile_print(model.geometry.tiles, bodies[i], caps[i], model.q.row(i).data(), i,
                             model.parameters.H_pin);
    out[i].piece = model.piece_of_tile[i];
    move(out[i], model.flat[i]);
  });
  return out;
}

}  // namespace curveups
