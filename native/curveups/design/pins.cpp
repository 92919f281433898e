// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/design/pins.hpp"

#include <cmath>

#include "curveups/design/pin_room.hpp"

namespace curveups {
namespace {

std::array<double, 3> insets(Side side, const double* q) {
  const double* own = q + inset_index(side, 0);
  return {own[0], own[1], own[2]};
}

}  // namespace

double wall_recess(const Parameters& parameters) {
  return parameters.bumps == "bumps" && parameters.bump_recess ? 0.5 * parameters.bump_height : 0.0;
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

PinBounds compute_pin_bounds(const TileMesh& tiles, const Truncation& truncation,
                             const Parameters& p) {
  const int count = tiles.tile_count();
  PinBounds out;
  out.lower.resize(count, 6);
  out.upper.resize(count, 6);
  out.least_area.resize(count, 2);
  for (int i = 0; i < count; ++i) {
    for (Side side : {Side::front, Side::back}) {
      auto with = [&](double p_min) { return pin_room(tiles, truncation, p, i, side, p_min); };
      PinRoom room = with(p.p_min);
      if (room.area < p.A_pin_floor) {
        double low = 0.1 * p.p_min, high = p.p_min;
        for (int k = 0; k < 30; ++k) {
          const double middle = 0.5 * (low + high);
          (with(middle).area >= 1.02 * p.A_pin_floor ? low : high) = middle;
        }
        room = with(low);
      }
      for (int t = 0; t < 3; ++t) {
        out.lower(i, inset_index(side, t)) = room.lower[t];
        out.upper(i, inset_index(side, t)) = room.upper[t];
      }
      // A hair of room where only a single point would be feasible.
      const bool small = room.area < p.A_pin_min * (1 + 1e-4);
      out.least_area(i, static_cast<int>(side)) = small ? 0.99 * room.area : p.A_pin_min;
      if (small) out.small.push_back({i, side, room.area});
      out.keepouts.insert(out.keepouts.end(), room.keepouts.begin(), room.keepouts.end());
    }
  }
  return out;
}

}  // namespace curveups
