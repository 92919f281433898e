// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/fabrication/print_parts.hpp"

#include <algorithm>
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

double least_distance(const Polygon& a, const Polygon& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2& q : a) least = std::min(least, distance(b, q));
  for (const Vec2& q : b) least = std::min(least, distance(a, q));
  return least;
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
