// SPDX-License-Identifier: LGPL-2.1-or-later
// A point of a tile in the flat plane and its derivatives.
#pragma once

#include "curveups/layout/layout_model.hpp"

namespace curveups {

// The pose among a tile's unknowns.
struct PlacedTile {
  explicit PlacedTile(const double* unknowns)
      : middle(unknowns[0], unknowns[1]), turn(unknowns[2]), insets(unknowns + 3) {}
  Vec2 middle;
  PlaneRotation turn;
  const double* insets;
};

// A point fixed to the tile: derivatives by x and y are the unit vectors, by the angle `by_angle`.
struct PlacedPoint {
  PlacedPoint(const PlacedTile& tile, const Vec2& local)
      : offset(tile.turn * local), position(tile.middle + offset), by_angle(left_of(offset)) {}
  Vec2 offset, position, by_angle;
};

}  // namespace curveups
