// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/pins.hpp"

#include <cmath>

namespace curveups {
namespace {

std::array<double, 3> insets(Side side, const double* q) {
  const double* own = q + inset_index(side, 0);
  return {own[0], own[1], own[2]};
}

}  // namespace

double wall_recess(const Parameters& parameters) {
  if (parameters.bumps != "bumps") return parameters.xy_compensation;
  return 0.5 * parameters.bump_height;
}

std::array<Vec2, 3> pin_corners(const TileMesh& tiles, int tile, Side side, const double* q) {
  return inset_triangle(tiles.corners(tile, side), insets(side, q));
}

double pin_area(const TileMesh& tiles, int tile, Side side, const double* q) {
  const double* own = q + inset_index(side, 0);
  double sum = 0;
  for (int t = 0; t < 3; ++t) {
    const double shift = side == Side::back ? tiles.back_shift(tile, t) : 0.0;
    sum += (own[t] + shift) * tiles.length(tile, t);
  }
  const double scale = 1 - sum / (2 * tiles.area(tile));
  return tiles.area(tile) * scale * std::abs(scale);
}

}  // namespace curveups
